"""geodesic-bench starts this script for each query to a Python function. It sends the query to the
process that has the function (functions.py) and prints the answer.

ask.py SOCKET VERTICES FACES SOURCES DISTANCES
"""

import json
import socket
import sys

with socket.socket(socket.AF_UNIX) as connection:
    connection.connect(sys.argv[1])
    connection.sendall(json.dumps(sys.argv[2:]).encode() + b"\n")
    with connection.makefile("r", encoding="utf-8") as stream:
        answer = json.loads(stream.readline() or '"the process that has the function has ended"')
if isinstance(answer, str):
    sys.exit(answer)
print("prepare_time", answer[0])
print("solve_time", answer[1])
