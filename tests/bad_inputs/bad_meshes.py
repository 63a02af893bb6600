"""Mesh files that are truncated, have wrong values, or are no mesh files."""

from __future__ import annotations

import struct

from case import Case

OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
OFF = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"
OFF_BINARY = b"OFF BINARY\n" + struct.pack(">3i9f5i", 3, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2, 0)
VERTICES = "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
FACES = "element face {}\nproperty list uchar int vertex_indices\nend_header\n"
CORNERS = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
BILLIONS = 4_000_000_000
MEANINGLESS = ["distances would be meaningless", "correct the mesh or use --repair"]
WHOLE_COPY = "get a whole copy"
UNKNOWN = ["wrong format", "the content is not OBJ, OFF, PLY or STL", "convert it to one of these"]


def ply(body: str | bytes, vertices: int = 3, faces: int = 1, encoding: str = "ascii") -> bytes:
    header = f"ply\nformat {encoding} 1.0\n" + VERTICES.format(vertices) + FACES.format(faces)
    return header.encode() + (body.encode() if isinstance(body, str) else body)


def stl(triangles: int, corners: bytes) -> bytes:
    """Returns a binary STL file."""
    return bytes(80) + struct.pack("<I", triangles) + bytes(12) + corners + bytes(2)


def mesh(what: str, file: str, content: str | bytes, *says: str) -> Case:
    return Case(
        f"{file}: {what}", f"geodesic-bench solve {file} --solver mmp --source 0", list(says),
        files={file: content},
    )  # fmt: skip


def crossed(what: str, flags: str, *says: str, asked: str = "solve --source 0", lines: int = 1) -> Case:
    fin = OBJ + "v 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 2 1 5\n"
    command = f"geodesic-bench {asked} fin.obj --cross-non-manifold {flags}"
    return Case(f"edge of three faces: {what}", command, list(says), files={"fin.obj": fin}, lines=lines)


def not_there(what: str, file: str, place: str) -> Case:
    return mesh(what, file, place, file, "a vertex that does not exist", "line ", *MEANINGLESS)


CASES = [
    crossed("a solver that does not cross it", "--solver ich",
            "ich does not cross edges of more than two faces; there are: edge-based, fwp-mmp, mmp"),
    crossed("a path of such a solver", "--solver ich", "ich does not cross edges of more than two faces; there are:",
            asked="path --through 2,3", lines=2),  # after the warning about the mesh
    crossed("a straightened path", "--straighten", "fin: a curve cannot be straightened on a mesh whose paths cross non-manifold",
            asked="path --through 2,3", lines=2),
    # OBJ
    mesh("a coordinate that is no number", "a.obj", OBJ + "v 0 x 0\nf 1 2 3\n",
         "a.obj, line 4: the y coordinate 'x' is not a number, such as 0.5"),
    mesh("a decimal comma", "a.obj", "v 0,5 0 0\n",
         "a.obj, line 1: the x coordinate '0,5' is not a number, such as 0.5"),
    mesh("NaN", "a.obj", OBJ + "v 0 nan 0\nf 1 2 4\n",
         "a.obj", "vertex 3 (line 4)", "not finite", *MEANINGLESS),
    mesh("infinity", "a.obj", OBJ + "v 0 inf 0\nf 1 2 4\n",
         "a.obj", "vertex 3 (line 4)", "not finite", *MEANINGLESS),
    mesh("beyond all numbers", "a.obj", OBJ + "v 0 1e9999 0\nf 1 2 4\n",
         "a.obj, line 4", "'1e9999' is beyond the range of numbers"),
    mesh("an extent of 1e45", "a.obj", "v 0 0 0\nv 1e45 0 0\nv 0 1 0\nf 1 2 3\n",
         "a.obj: the longest side of the mesh is 1e+45, and must be from 1e-20 to 1e+20; scale it"),
    mesh("a vertex of two coordinates", "a.obj", "v 0 0\n" + OBJ + "f 1 2 3\n",
         "a.obj, line 1: the z coordinate is missing"),
    mesh("a face of two corners", "a.obj", OBJ + "f 1 2\n",
         "a.obj", "1 face of fewer than three different vertices (first: face 0 (line 4)", *MEANINGLESS),
    not_there("an index out of range", "a.obj", OBJ + "f 1 2 4\n"),
    not_there("a negative index out of range", "a.obj", OBJ + "f 1 2 -4\n"),
    not_there("the index 0", "a.obj", OBJ + "f 1 2 0\n"),
    mesh("no vertices", "a.obj", "# nothing\n", "a.obj: empty mesh: no vertices"),
    mesh("no faces", "a.obj", OBJ, "a.obj: empty mesh: no faces"),
    mesh("a line of five million digits", "a.obj", "v " + 5_000_000 * "1" + " 0 0\n",
         "a.obj, line 1", "is beyond the range of numbers"),
    mesh("prose", "a.obj", "Dear Sir or Madam\n", "a.obj, line 1: unknown statement 'Dear'"),
    mesh("escape sequences", "a.obj", b"v 0 0 0\nv 1 0 \x1b[2J\n", "a.obj: wrong format"),
    # OFF
    mesh("4 billion vertices in 24 bytes", "a.off", f"OFF\n{BILLIONS} 1 0\n0 0 0\n",
         "a.off, line 2: the header declares 4000000000 vertices", WHOLE_COPY),
    mesh("cut", "a.off", OFF, "a.off, line", "truncated", WHOLE_COPY),
    mesh("a face cut off between two lines", "a.off", OFF + "4 0 1\n2\n",
         "a.off, line 8: the file ends before the end of face 0 of 1", "truncated", WHOLE_COPY),
    mesh("an edge as a face", "a.off", OFF.replace("1 0\n", "2 0\n", 1) + "3 0 1 2\n2 0 1\n",
         "1 face of fewer than three different vertices (first: face 1 (line 7)", *MEANINGLESS),
    not_there("an index out of range", "a.off", OFF + "3 0 1 7\n"),
    not_there("a negative index", "a.off", OFF + "3 0 1 -2\n"),
    mesh("counts that are none", "a.off", "OFF\n3 x 0\n0 0 0\n1 0 0\n",
         "a.off, line 2: the number of faces 'x' is not an integer, such as 12"),
    mesh("binary and cut", "a.off", OFF_BINARY[:-6],
         "a.off, byte 71: the file ends before the end of face 0 of 1", WHOLE_COPY),
    mesh("binary and of the other byte order", "a.off", b"OFF BINARY\n" + struct.pack("<3i", 3, 1, 0),
         "a.off, byte 23: the header declares 50331648 vertices", WHOLE_COPY),
    mesh("another word than OFF", "a.off", "OFX\n3 1 0\n", "a.off", *UNKNOWN),
    # PLY
    mesh("cut in the header", "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n",
         "a.ply, line 4: the file ends before 'end_header'", WHOLE_COPY),
    mesh("cut in the vertices", "a.ply", ply("0 0 0\n1 0 0\n"),
         "a.ply, line", "the file is truncated", WHOLE_COPY),
    mesh("an unknown encoding", "a.ply", ply("", encoding="binary_middle_endian"),
         "a.ply, line 2: unknown encoding 'binary_middle_endian'", "there are ascii"),
    mesh("4 billion vertices", "a.ply", ply(CORNERS, BILLIONS, 1, "binary_little_endian"),
         "a.ply", "4000000000", "truncated", WHOLE_COPY),
    mesh("binary and cut in the faces", "a.ply",
         ply(CORNERS + b"\x03", encoding="binary_little_endian"), "a.ply, byte", WHOLE_COPY),
    mesh("a triangle strip of one vertex", "a.ply",
         ply("0 0 0\n1 0 0\n0 1 0\n5 0 1 2 -1 1\n").replace(b"element face", b"element tristrips"),
         "1 face of fewer than three different vertices (first: face 1 (line 13)", *MEANINGLESS),
    mesh("another word than ply", "a.ply", "plx\nformat ascii 1.0\n", "a.ply", *UNKNOWN),
    not_there("an index out of range", "a.ply", ply("0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n").decode()),
    # STL
    mesh("cut", "a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
         "a.stl, line 5: the file ends before 'vertex'", WHOLE_COPY),
    mesh("4 billion triangles", "a.stl", stl(BILLIONS, CORNERS),
         "a.stl, byte 80", "declares 4000000000 triangles", WHOLE_COPY),
    mesh("NaN", "a.stl", stl(1, struct.pack("<9f", *8 * [0.0], float("nan"))),
         "a.stl", "not finite", *MEANINGLESS),
    # Any file name
    *(mesh(f"{encoding} with its byte order mark", file, "\ufeff".encode(encoding) + text.encode(encoding),
           f"{file}: the text is UTF-16; save it as UTF-8")
      for encoding in ("utf-16-le", "utf-16-be")
      for file, text in (("a.obj", OBJ + "f 1 2 3\n"), ("a.off", OFF + "3 0 1 2\n"), ("a.stl", "solid\n"),
                         ("a.ply", ply("").decode()))),
    mesh("empty", "a.off", "", "a.off: the file is empty (0 bytes); get a whole copy"),
    mesh("noise", "a.obj", bytes(range(256)), "a.obj", *UNKNOWN),
    mesh("compressed", "a.ply", b"\x1f\x8b\x08\x00", "a.ply: a compressed file", "unpack it first"),
    mesh("a program", "a.obj", b"\x7fELF\x02\x01\x01\x00", "a.obj", *UNKNOWN),
    Case("a folder", "geodesic-bench solve folder --solver mmp --source 0",
         ["'folder' is not a regular file"], given="mkdir folder"),
    Case("a folder without meshes", "geodesic-bench run --meshes folder/",
         ["no mesh file in folder 'folder/': .obj, .off, .ply or .stl"],
         given="mkdir folder; touch folder/notes.txt"),
    Case("a pattern that matches nothing", "geodesic-bench verify --solver mmp --meshes 'f/*.ply'",
         ["no mesh file matches 'f/*.ply': .obj, .off, .ply or .stl"]),
    Case("two meshes of one name", "geodesic-bench run --meshes a/,b/",
         ["two meshes are named 'hill', and results go by name: rename ", "/a/hill.obj or ",
          "/b/hill.obj"],
         given="mkdir a b; cp hill.obj a; cp hill.obj b"),
    Case("a name in a folder that no result file can hold", "geodesic-bench run --meshes folder",
         ["folder/a\\x0a.obj", "rename"], given="mkdir folder; cp hill.obj $'folder/a\n.obj'"),
    Case("a pipe, which nobody waits for", "geodesic-bench mesh pipe",
         ["pipe: a folder, pipe or device; name a file"], given="mkfifo pipe"),
    Case("an endless device", "geodesic-bench mesh /dev/zero", ["/dev/zero: a folder, pipe or device"]),
    Case("nothing there", "geodesic-bench mesh nothing.obj",
         ["nothing.obj: no such file; check the path"]),
    Case("a link to itself", "geodesic-bench mesh loop.obj", ["loop.obj"],
         given="ln -s loop.obj loop.obj"),
    Case("unreadable", "unprivileged geodesic-bench mesh hill.obj",
         ["hill.obj: cannot be opened: Permission denied"], given="chmod 000 hill.obj",
         needs="unprivileged"),
    Case("a name that would clear the screen", r"geodesic-bench mesh $'\e[2J\n.obj'",
         [r"\x1b[2J\x0a.obj: no such file; check the path"]),
]  # fmt: skip
