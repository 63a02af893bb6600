"""Sources and targets that are not points of the mesh, as arguments and in files."""

from __future__ import annotations

import json

from case import Case

SOLVE = "geodesic-bench solve hill.obj --solver mmp"


def word(point: str, *says: str) -> Case:
    return Case(point, f"{SOLVE} --source '{point}'", ["--source", *says])


def target(words: str, *says: str) -> Case:
    return Case(words, f"{SOLVE} --source 0 {words}", [*says])


def file(what: str, content: str | bytes | list[object], *says: str) -> Case:
    text = json.dumps(content) if isinstance(content, list) else content
    command = f"{SOLVE} --source 0 --targets-file points"
    return Case(f"a file: {what}", command, ["--targets-file 'points'", *says],
                files={"points": text})  # fmt: skip


def pairs(what: str, content: str | list[object], *says: str) -> Case:
    text = json.dumps(content) if isinstance(content, list) else content
    return Case(f"pairs: {what}", f"{SOLVE} --pairs points", ["--pairs 'points'", *says], files={"points": text})


def sets(what: str, content: str | list[object], *says: str) -> Case:
    text = json.dumps(content) if isinstance(content, list) else content
    return Case(f"sets: {what}", f"{SOLVE} --sets points", ["--sets 'points'", *says], files={"points": text})


def avoided(what: str, content: str | list[object], *says: str) -> Case:
    text = json.dumps(content) if isinstance(content, list) else content
    return Case(f"avoided: {what}", f"{SOLVE} --source 0 --avoid wall", [*says], files={"wall": text})


CASES = [
    word("-1", "'-1' is not a point, such as 12 (a vertex), edge:3-7:0.25, face:345:0.2,0.3,0.5"),
    word("1.5", "'1.5' is not a point"),
    word("0x1", "'0x1' is not a point"),
    word("1,two,3", "'two' is not a point"),
    word("9999999999", "'9999999999' has a number that is too large"),
    word("99", "--source 99: vertex 99 is not in the mesh of 4 vertices"),
    word("edge:0-1", "'edge:0-1' is not a point"),
    word("edge:0-9:0.5", "edge:0-9:0.5: vertex 9 is not in the mesh of 4 vertices"),
    word("edge:1-1:0.5", "edge:1-1:0.5: no edge joins vertices 1 and 1"),
    word("edge:0-1:1.5", "edge:0-1:1.5: the share of an edge must lie between 0 and 1"),
    word("edge:0-1:nan", "edge:0-1:nan: a number is not finite"),
    word("face:0:0.5,0.5", "'face:0:0.5,0.5' is not a point"),
    word("face:9:0.5,0.5,0", "face:9:0.5,0.5,0: face 9 is not in the mesh of 4 faces"),
    word("face:0:0.5,0.5,0.5", "the weights sum up to 1.5; their sum must be 1"),
    word("face:0:-0.5,0.5,1", "face:0:-0.5,0.5,1: a weight is negative"),
    word("face:0:inf,0,0", "face:0:inf,0,0: a number is not finite"),
    word("at:0,1", "'at:0,1' is not a point"),
    word("at:0,1,nan", "at:0,1,nan: a number is not finite"),
    word("0+-1", "0+-1: an initial distance must be finite and not negative"),
    word("0:0.5", "'0:0.5' is not a point", "+0.5 behind it is an initial distance"),
    target("--target 1+0.5", "--target 1+0.5: a target has no initial distance"),
    target("--stop-at-targets", "--stop-at-targets needs --target"),
    target("--paths p.obj", "--paths needs --target"),
    target("--paths p.stl --target 1", "p.stl", "paths and isolines are written as .json, .obj or .ply"),
    target("--paths hill.obj --target 1", "--paths 'hill.obj' is the mesh itself"),
    target("--paths p.obj --target 1 --each", "--paths, --nearest-source and --angles are for one solve"),
    target("--isolines i.obj", "--isolines and --levels need each other"),
    target("--levels 3", "--isolines and --levels need each other"),
    target("--isolines i.stl --levels 3", "i.stl", "paths and isolines are written as .json, .obj or .ply"),
    target("--isolines hill.obj --levels 3", "--isolines 'hill.obj' is the mesh itself"),
    target("--isolines i.obj --levels 3 --each", "--isolines is for one solve: leave out --each"),
    target("--isolines i.obj --levels 3 --paths ./i.obj --target 1", "--isolines and --paths need a file each"),
    *(target(f"--isolines i.obj --levels={levels}", f"--levels: '{levels}' is neither a number of levels, from 1 to"
             " 10000, nor distances above 0, such as 0.5 or 1,2.5")
      for levels in ("0", "10001", "99999999999", "-1", "0.0", "nan", "inf", "1,", ",1", "1,,2", "1,x", "1e999")),
    target("--nearest-source", "--nearest-source needs --output"),
    target("--angles", "--angles needs --output"),
    target("--target 1 --stop-at-targets --check", "--check is for distances without --limit and"),
    Case("paths of a solver that remembers none",
         "geodesic-bench solve hill.obj --solver virtual-source --source 0 --target 1 --paths p.obj",
         ["virtual-source does not remember how paths arrive", "there are: ", "ich"]),
    Case("paths between points of faces of a solver that knows vertices",
         "geodesic-bench solve hill.obj --solver dijkstra --source 0 --target face:0:0.2,0.3,0.5 --paths p.obj",
         ["dijkstra traces paths between vertices only", "there are: ", "ich"]),
    Case("a file: missing", f"{SOLVE} --sources-file nowhere",
         ["--sources-file nowhere: no such file"]),
    file("empty", "", "the file is empty"),
    file("separators only", " ,\n,", "there is no point in it"),
    Case("a file: UTF-16", f"{SOLVE} --source 0 --targets-file points",
         ["--targets-file points: the text is UTF-16; save it as UTF-8"],
         files={"points": "0 1".encode("utf-16")}),
    file("a word", "0, edge:0-1:0.5\nseven", "'seven' is not a point"),
    file("an empty list", [], "there is no point in it"),
    file("cut", "[0, 1", "not valid JSON"),
    file("no list", '{"vertex": 0}', "a list of points is expected"),
    file("an object", [0, {"vertex": 0}], "point 1: an object is not a number, a string or a list"),
    file("a fraction for a vertex", [0.5], "point 0: '0.5' is not a point, such as 12"),
    file("too great a sum", ["face:0:1,1,1"], "point 0 face:0:1,1,1: the weights sum up to 3"),
    file("three numbers that may be vertices or a place", "1,2,0\n",
         "line 1: '1,2,0' may be three vertices or a place: write each vertex by itself, or the place as at:1,2,0"),
    file("a table that may be of vertices or places", "1 2 0\n0 1 2\n", "line 1: '1,2,0' may be", "x,y,z"),
    file("a list that may be of vertices or a place", [0, [1, 2, 0]], "point 1: '1,2,0' may be three vertices or"),
    file("places, and three numbers that may be vertices", "0.5,0,0\n3\n1,2,0\n", "line 3: '1,2,0' may be three"),
    file("two coordinates", [[0.5, 1]], "point 0: a list within the list is a place, [x, y, z]"),
    file("places with numbers of their own", "x,y,z\n0,0.5,0\n7,0.5,0,0\n",
         "line 3: '7,0.5,0,0' is not three numbers, the x, y and z of a place"),
    file("four numbers", "0.5,0,0,1\n", "line 1: '0.5' is not a point, such as 12"),
    file("a place that is not finite", "0.5,nan,0\n", "line 1 at:0.5,nan,0: a number is not finite"),
    file("no place after the names of coordinates", "x,y,z\n", "there is no point in it"),
    file("several in a string", ["0,1"], "point 0: a string holds one point"),
    file("an initial distance", ["1+1"], "a target has no initial distance"),
    file("a vertex that is not there", [99], "point 0 99: vertex 99 is not in the mesh"),
    Case("avoided: missing", f"{SOLVE} --source 0 --avoid-faces nowhere", ["--avoid-faces nowhere: no such file"]),
    avoided("empty", "", "--avoid 'wall': the file is empty"),
    avoided("no number", "[]", "--avoid 'wall': there is no number in it"),
    avoided("a point", "0\nedge:0-1:0.5\n", "--avoid 'wall', line 2: 'edge:0-1:0.5' is not the number of a vertex or"),
    avoided("a negative number", "-1", "line 1: '-1' is not the number of a vertex or face, such as 12"),
    avoided("too large", "99999999999", "line 1: '99999999999' is not the number of a vertex or face"),
    avoided("a boolean", [True], "item 0: 'true' is not the number of a vertex or face"),
    avoided("no list", "{}", "a list of numbers is expected"),
    avoided("a mask", "0 0 1 0", "hill.obj: the list of avoided vertices has only the numbers 0 and 1"),
    avoided("a vertex that is not there", "99", "hill.obj: avoided vertex 99 is not in the mesh of 4 vertices"),
    avoided("all", "0 1 2 3", "hill.obj: no face is left: all of them are avoided"),
    Case("avoided: a source in an avoided face", f"{SOLVE} --source face:0:0.5,0.25,0.25 --avoid-faces wall",
         ["face 0 is avoided; name a point in another face"], files={"wall": "0"}),
    Case("pairs: missing", f"{SOLVE} --pairs nowhere", ["--pairs nowhere: no such file"]),
    pairs("empty", " \n", "the file is empty"),
    pairs("separators only", ",\n", "there is no pair in it"),
    pairs("an empty list", [], "there is no pair in it"),
    pairs("no list", '{"from": 0}', "a list of pairs is expected"),
    pairs("one point", "0 1\n2\n", "line 2: a pair is two points, not 1"),
    pairs("three points", "0,1,2\n", "line 1: a pair is two points, not 3"),
    pairs("a place without its third number", "0 0 0.5 1 0\n", "line 1: '0.5' is not a point, such as 12"),
    pairs("names of columns", "from,to\n0,1\n", "line 1: 'from' is not a point, such as 12"),
    pairs("a list of points", [0, 1], "pair 0: a list of points is expected"),
    pairs("a list of three", [[0, 1], [0, 1, 2]], "pair 1: a pair is two points, not 3"),
    pairs("a pair without points", [[]], "pair 0: there is no point in it"),
    pairs("numbers that may be vertices or a place", [[0, [1, 2, 0]]], "pair 0, point 1: '1,2,0' may be three vertices"),
    pairs("an initial distance", "0 1+0.5\n", "line 1 1+0.5: a point of a pair has no initial distance"),
    pairs("a vertex that is not there", "0 1\n1 99\n", "line 2 99: vertex 99 is not in the mesh of 4 vertices"),
    Case("sets: missing", f"{SOLVE} --sets nowhere", ["--sets nowhere: no such file"]),
    Case("sets: a folder", f"{SOLVE} --sets .", ["--sets .: a folder, pipe or device; name a file"]),
    Case("sets: a mesh of distances", f"{SOLVE} --sets points --output d.vtk",
         ["'d.vtk' is a mesh with the distances of one query: with --each, --sets, --pairs"], files={"points": "0 1"}),
    *(Case(f"{output} is the file of {inputs}", f"{SOLVE} {words} {inputs} {name} {output} {name}",
           [f"{output} '{name}' is the file of {inputs}: results go to a file of their own"], files={name: "0 1"})
      for words, inputs, output, name in (
          ("", "--sets", "--output", "points.csv"), ("", "--pairs", "--output", "points.txt"),
          ("", "--sources-file", "--output", "points.csv"), ("--source 0", "--targets-file", "--paths", "points.json"),
          ("--source 0 --levels 3", "--avoid", "--isolines", "wall.obj"))),
    sets("empty", " \n", "the file is empty"),
    sets("separators only", ",\n", "there is no set in it"),
    sets("an empty list", [], "there is no set in it"),
    sets("no list", '{"sets": 0}', "a list of sets is expected"),
    sets("a set without points", [[0], []], "set 1: there is no point in it"),
    sets("no point", [[0], None], "set 1, point 0: null is not a number, a string or a list"),
    sets("a word", "0 1\nleft\n", "line 2: 'left' is not a point, such as 12"),
    sets("a place without at:", "0,1,2\n0.5,1,0\n", "line 2: '0.5' is not a point, such as 12", "at:0.1,2,-3"),
    sets("a place without at: in a list", [[0.5, 1, 0]], "set 0, point 0: '0.5' is not a point, such as 12"),
    sets("numbers that may be vertices or a place", [[0, [1, 2, 0]]], "set 0, point 1: '1,2,0' may be three vertices"),
    sets("a vertex that is not there", "0 1\n1 99\n", "line 2 99: vertex 99 is not in the mesh of 4 vertices"),
]  # fmt: skip
