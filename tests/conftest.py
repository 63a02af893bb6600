"""Of all tests: what they must not inherit from the shell they are started in."""

import signal

# Shells have what they start with `&` ignore Ctrl-C, and programs hand that down.
signal.signal(signal.SIGINT, signal.default_int_handler)
