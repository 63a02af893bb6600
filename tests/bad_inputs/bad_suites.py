"""Suites that say something they must not."""

from __future__ import annotations

from case import Case

NESTED = '{"sources": ' + 100_000 * "[" + 100_000 * "]" + "}"


def suite(what: str, text: str, *says: str) -> Case:
    return Case(
        what, "geodesic-bench run suite.json --out run", [*says], files={"suite.json": text}
    )


CASES = [
    Case("nothing there", "geodesic-bench run suite.json",
         ["cannot read 'suite.json'", "name a suite, such as ", "default.json"]),
    Case("a folder", "geodesic-bench run folder", ["cannot read 'folder': it is a folder"],
         given="mkdir folder"),
    suite("empty", "", "suite.json: not valid JSON", "line 1, column 1", "get a whole copy"),
    suite("cut", '{"solvers": ["mmp"', "suite.json: not valid JSON", "line 1, column 19"),
    suite("a list", "[]", "suite.json: a suite is a JSON object"),
    suite("an unknown key", '{"source": 1}', "suite.json: no key of a suite named 'source'",
          "(did you mean 'sources'?)"),
    suite("an unknown key that would colour the terminal", r'{"\u001b[31m": 1}',
          r"suite.json: no key of a suite named '\x1b[31m'"),
    suite("a word for a count", '{"sources": "two"}',
          'suite.json: "sources": "two" is not a non-negative integer'),
    suite("a fraction for a count", '{"repetitions": 2.5}',
          'suite.json: "repetitions": 2.5 is not a non-negative integer'),
    suite("too large a count", '{"sources": 99999999999}', '"sources"', "at most 2147483647"),
    suite("a number beyond all numbers", '{"min_time": 1e999}', "suite.json", "1e999"),
    suite("no time at all", '{"min_time": 0}', "suite.json: min_time", "positive number of sec"),
    suite("a name for a list of names", '{"solvers": "mmp"}',
          'suite.json: "solvers": "mmp": type must be array, but is string'),
    suite("nothing for a name", '{"reference": null}', '"reference": null: type must be string'),
    suite("nested 100,000 deep", NESTED, "suite.json: lists and objects are nested more than 50 deep"),
    suite("an unknown solver", '{"solvers": ["mpp"]}', "no solver named 'mpp' (did you mean 'mmp'"),
    suite("one solver twice", '{"solvers": ["mmp", "mmp"]}', "solver 'mmp' is named twice"),
    suite("two meshes of one name", '{"meshes": ["hill.obj", "./hill.obj"]}',
          "two meshes are named 'hill', and results go by name: rename ", "hill.obj or "),
    suite("an unknown corpus", '{"corpus": "quik"}', "no corpus named 'quik' (did you mean '"),
    suite("a reference that is not exact", '{"reference": "dijkstra"}', "'dijkstra' is not exact"),
    suite("a mesh that cannot be read", '{"meshes": ["suite.json"]}',
          "nothing to run", "suite.json: wrong format", "convert it to one of these"),
]  # fmt: skip
