"""Files that are not plug-ins. tests/package/test_plugins.py builds plug-ins that are refused."""

from __future__ import annotations

from case import Case


def plugin(what: str, content: str | bytes, *says: str) -> Case:
    return Case(what, "geodesic-bench --plugin ./plug.so list", ["plug-in './plug.so': ", *says],
                files={"plug.so": content})  # fmt: skip


CASES = [
    Case("nothing there", "geodesic-bench --plugin nowhere.so list",
         ["plug-in 'nowhere.so': there is no such file"]),
    Case("a folder", "geodesic-bench --plugin . list", ["plug-in '.': it is not a regular file"]),
    plugin("empty", "", "it is not a shared library that can be loaded"),
    plugin("a text", "solver\n", "it is not a shared library that can be loaded"),
    plugin("the beginning of a library", b"\x7fELF\x02\x01\x01" + bytes(57),
           "it is not a shared library that can be loaded"),
    Case("a library without a solver", "geodesic-bench --plugin $(ls /lib*/*/libm.so.6) list",
         ["it registers no solver: that takes a RegisterSolver at namespace scope"]),
]  # fmt: skip
