"""Suites with invalid contents."""

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
    suite("a list", "[]", "suite.json: must be an object, not an array"),
    suite("an unknown key", '{"source": 1}', "suite.json: no key named 'source'",
          "(did you mean 'sources'?)", "min_time, other_queries, path_targets, reference"),
    suite("an unknown key that would colour the terminal", r'{"\u001b[31m": 1}',
          r"suite.json: no key named '\x1b[31m'"),
    suite("a word for a count", '{"sources": "two"}',
          'suite.json: sources: must be an integer from 0 to 2147483647, not "two"'),
    suite("a fraction for a count", '{"repetitions": 2.5}',
          "suite.json: repetitions: must be an integer from 0 to 2147483647, not 2.5"),
    suite("too large a count", '{"sources": 4294967297}', "sources: ", "2147483647, not 4294967297"),
    suite("a negative count", '{"other_queries": -1}', "other_queries: must be an integer", "not -1"),
    suite("a negative seed", '{"seed": -1}', "seed: must be an integer from 0 to", "not -1"),
    suite("no source", '{"sources": 0}', "sources: ", "at least one source"),
    suite("no repetition", '{"repetitions": 0}', "repetitions: ", "at least one repetition"),
    suite("no set of sources", '{"source_sets": ["random"]}', "no set of sources: random"),
    suite("a set of sources twice", '{"source_sets": ["boundary", "boundary"]}',
          "source_sets: two sets are called 'boundary'"),
    suite("a corpus that leads out of a folder", '{"corpus": "../../a"}',
          "invalid corpus name '../../a'"),
    suite("unknown instructions", '{"vectors": "wide"}', "no kind of vectors named 'wide'"),
    suite("a number beyond all numbers", '{"min_time": 1e999}', "suite.json", "1e999"),
    suite("no time at all", '{"min_time": 0}', "suite.json: min_time", "positive number of sec"),
    suite("a name for a list of names", '{"solvers": "mmp"}',
          'suite.json: solvers: must be a list, not "mmp"'),
    suite("nothing for a name", '{"reference": null}', "reference: must be text, not null"),
    suite("a word for a time", '{"min_time": "1"}', 'min_time: must be a number of seconds, not "1"'),
    suite("no cell that an outcome is expected of", '{"expected": {"mmp": "crashed"}}',
          'expected: mmp: must be solver/mesh, such as mmp/horse, not "mmp"'),
    suite("an outcome that is no failure", '{"expected": {"mmp/hill": "ok"}}',
          "expected: mmp/hill: must be one of unsupported, out of memory,", 'not "ok"'),
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
