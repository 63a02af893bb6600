"""Bad arguments of all programs."""

from __future__ import annotations

from pathlib import Path

from case import Case

GOLDEN = Path(__file__).resolve().parents[1] / "plots" / "golden" / "run" / "run.json"

SOLVE = "geodesic-bench solve hill.obj --solver mmp --source 0"
SEE = "(see geodesic-bench {} --help)"


def flag(command: str, *says: str) -> Case:
    return Case(command, command, list(says))


def of(command: str, words: str, *says: str) -> Case:
    """Arguments of a command. The message must name the help of this command."""
    return flag(f"geodesic-bench {command} {words}", *says, SEE.format(command))


def script(command: str, words: str, *says: str) -> Case:
    """Arguments of a command that is a Python module."""
    see = f"; see geodesic-bench {command} --help"
    return flag(f"geodesic-bench {command} {words}", f"geodesic-bench {command}: ", *says, see)


CASES = [
    # geodesic-bench
    flag("geodesic-bench", "which command?", "solve", "(see geodesic-bench --help)"),
    flag("geodesic-bench slove", "no command named 'slove' (did you mean 'solve'?)"),
    flag("geodesic-bench slove --help", "no command named 'slove' (did you mean 'solve'?)"),
    flag("geodesic-bench --plugin", "--plugin needs a value", "(see geodesic-bench --help)"),
    flag(r"geodesic-bench $'\e[31mred'", r"no command named '\x1b[31mred'"),
    flag("geodesic-bench solve --sorce 1 --help", "'--sorce' (did you mean '--source'?)"),
    # solve
    of("solve", "", "mesh is required"),
    flag("geodesic-bench solve hill.obj", "--source, --sources-file, --sets or --pairs is required"),
    flag(f"{SOLVE} --counters --each", "--counters is for one solve: leave out --each"),
    flag(f"{SOLVE} --check --limit 1", "--check is for distances without --limit"),
    of("solve", "hill.obj --solver", "--solver needs a value"),
    of("solve", "hill.obj --output d.txt --output e.txt", "--output takes at most 1 value, not 2"),
    of("trace", "hill.obj --direction 1,1", "--direction takes at least 3 values, not 2"),
    of("trace", "hill.obj --direction 1,1,1,1", "--direction takes at most 3 values, not 4"),
    flag(f"{SOLVE} hill.obj --output d.txt", "--output, --paths and --isolines are files of one mesh"),
    flag(f"{SOLVE} hill.obj --out .", "two of the meshes would be written to ./hill.txt"),
    of("solve", "hill.obj --solver ''", "--solver: must not be empty"),
    of("solve", "hill.obj --limit 0,5", "--limit: '0,5' is not a number, such as 0.5"),
    of("solve", "hill.obj --limit nan", "--limit: 'nan' is not a number, such as 0.5"),
    of("solve", "hill.obj --limit=-1", "--limit: '-1' is not 0 or greater"),
    of("solve", "hill.obj --weld=-1", "--weld: '-1' is not 0 or greater"),
    of("mesh", "hill.obj --weld inf", "--weld: 'inf' is not 0 or greater"),
    of("mesh", "hill.obj --weld=near", "--weld: 'near' is not a number, such as 0.5"),
    flag("geodesic-bench mesh --weld 9 hill.obj", "every face collapses when vertices are joined"),
    *(of("solve", f"hill.obj --pairs p {other}", "--pairs", "excludes", other.split()[0])
      for other in ("--source 0", "--sources-file s", "--target 1", "--targets-file t", "--stop-at-targets", "--limit 1",
                    "--nearest-source", "--angles", "--paths p.obj", "--each", "--check", "--counters")),
    *(of("solve", f"hill.obj --sets s {other}", "--sets", "excludes", other.split()[0])
      for other in ("--source 0", "--sources-file s", "--pairs p", "--each", "--nearest-source", "--angles",
                    "--paths p.obj", "--isolines i.obj", "--levels 3", "--counters")),
    of("solve", "hill.obj --source 0 --prepared p --solver mmp", "--solver excludes --prepared"),
    flag("geodesic-bench solve hill.obj --source 0 --solver mmp --save-prepared p",
         "mmp has no preparation that could be saved", "straight-graph"),
    flag("geodesic-bench solve hill.obj --source 0 --solver straight-graph --save-prepared hill.obj",
         "--save-prepared 'hill.obj' is the mesh itself"),
    flag("geodesic-bench solve hill.obj --source 0 --prepared none",
         "--prepared none: No such file or directory"),
    flag("geodesic-bench solve hill.obj --source 0 --prepared hill.obj",
         "--prepared hill.obj: this is not the preparation of a solver"),
    of("solve", "hill.obj --threads 0", "--threads: '0' is not between 1 and 1024"),
    flag("geodesic-bench solve hill.obj --solver mpp --source 0",
         "no solver named 'mpp' (did you mean 'mmp'?)"),
    flag("geodesic-bench solve hil --solver mmp --source 0", "no mesh named 'hil'", "the nearest of"),
    flag("geodesic-bench solve meshes/hil.obj --solver mmp --source 0",
         "cannot open 'meshes/hil.obj': No such file or directory"),
    flag("geodesic-bench solve bunny.xyz --solver mmp --source 0",
         "cannot open 'bunny.xyz': No such file or directory"),
    flag("geodesic-bench solve horse --solver mmp --source 0",
         "mesh 'horse' is not in the dataset cache", "run ", "fetch.py horse"),
    flag(f"{SOLVE} --threads 2", "--threads is for --each"),
    flag(f"{SOLVE} --vectors sse9", "no kind of vectors named 'sse9'", "auto, plain"),
    flag(f"{SOLVE} --output hill.obj", "--output 'hill.obj' is the mesh itself"),
    flag(f"{SOLVE} --output d.dat", "cannot write 'd.dat'", ".txt, .csv or .npy"),
    flag(f"{SOLVE} --output nowhere/d.txt", "cannot write 'nowhere/d.txt'", "No such file"),
    flag(f"{SOLVE} --output .", "cannot write '.': it is a folder"),
    flag(f"{SOLVE} --output d.ply --each", "'d.ply' is a mesh with the distances of one query"),
    # path and trace
    of("path", "hill.obj", "--through is required"),
    flag("geodesic-bench path hill.obj --through 0", "at least two"),
    flag("geodesic-bench path hill.obj --through 0,99", "--through 99: vertex 99 is not in the mesh"),
    flag("geodesic-bench path hill.obj --through 0,1 --solver dijkstra", "remember paths: take another solver"),
    flag("geodesic-bench path hill.obj --through 0,1,2 --closed --straighten", "the loop shrinks to a point"),
    of("trace", "hill.obj --length 1", "--from is required"),
    flag("geodesic-bench trace hill.obj --from 0 --length 1", "one of --direction and --angle is needed"),
    flag("geodesic-bench trace hill.obj --from 0,1 --length 1 --angle 0", "--from takes one point"),
    flag("geodesic-bench trace hill.obj --from 99 --length 1 --angle 0", "--from 99: vertex 99 is not in the mesh"),
    flag("geodesic-bench trace hill.obj --from 0 --length=-1 --angle 0", "the length of a line must be from 0 to"),
    flag("geodesic-bench trace hill.obj --from 0 --length 1 --direction 0,0,0", "a direction must be finite and not 0"),
    flag("geodesic-bench trace hill.obj --from 0 --length 1 --angle 0 -o l.stl", "l.stl"),
    flag("geodesic-bench trace hill.obj --from 0+1 --length 1 --angle 0", "--from 0+1: only a source has an initial"),
    flag("geodesic-bench path hill.obj --through 0,1+1", "--through 1+1: only a source has an initial distance"),
    flag("geodesic-bench trace hill.obj --from 0 --length 1 --angle 0 -o hill.obj", "--output 'hill.obj' is the mesh itself"),
    flag("geodesic-bench path hill.obj --through 0,1 -o ./hill.obj", "--output './hill.obj' is the mesh itself"),
    # list, mesh, generate
    of("list", "more", "list: unexpected 'more'"),
    flag("geodesic-bench list --corpus quik", "no corpus named 'quik' (did you mean 'quick'?)"),
    of("mesh", "", "FILE is required"),
    flag("geodesic-bench mesh hill.obj --output hill.xyz",
         "cannot write 'hill.xyz': a mesh is written as .obj, .off or .ply"),
    flag("geodesic-bench generate", "needs the NAME of a generator and -o FILE, or --list"),
    flag("geodesic-bench generate spher -o a.obj", "no generator named 'spher'", "icosphere"),
    flag("geodesic-bench generate icosphere --frequenzy 4 -o a.obj",
         "icosphere: no parameter named 'frequenzy' (did you mean 'frequency'?)"),
    flag("geodesic-bench generate icosphere --frequency 0,5 -o a.obj", "frequency", "'0,5'"),
    flag("geodesic-bench generate icosphere --frequency -o a.obj", "--frequency has no value"),
    flag("geodesic-bench generate icosphere more -o a.obj", "unexpected 'more'", "--name value"),
    flag("geodesic-bench generate --list icosphere", "--list takes no other argument"),
    # run
    flag("geodesic-bench run --sources 0", "sources", "at least one"),
    flag("geodesic-bench run --vectors sse9", "no kind of vectors named 'sse9'", "auto, plain, avx2"),
    of("run", "--sources many", "--sources: 'many' is not an integer"),
    of("run", "--seed -1", "--seed: '-1' is not a non-negative integer"),
    of("run", "--corpus ''", "--corpus: must not be empty"),
    flag("geodesic-bench run --min-time 0", "min_time", "a positive number of seconds"),
    flag("geodesic-bench run --recordings sometimes",
         "no choice of recordings named 'sometimes'; there are: none, auto, all"),
    flag("geodesic-bench run a.json b.json", "a run takes one suite, not both 'a.json' and"),
    flag("geodesic-bench run -- --benchmark_nope", "--benchmark_nope", "that make sense here"),
    flag(r"geodesic-bench run --meshes $'\xff.obj'", "not UTF-8", "rename the file"),
    # rank
    script("rank", "--against mmp", "--solver is required"),
    script("rank", "--solver mmp --against mmp", "'mmp' cannot be ranked against itself"),
    script("rank", "--solver mmp --against ich,ich", "--against has 'ich' twice"),
    script("rank", "--solver mmp --against ich --pairs 0", "'0' is not a number from 1 to 1000"),
    script("rank", "--resume a --run b", "give only one of --resume and --run"),
    flag("geodesic-bench view hill.obj --output page.txt", "--output page.txt: the page is written as .html"),
    flag("geodesic-bench publish --output mine.txt", "--output mine.txt: a result is written as .json"),
    flag("geodesic-bench rank --run nowhere", "geodesic-bench rank: nowhere: no such folder"),
    # verify
    flag("geodesic-bench verify", "--solver is required (geodesic-bench list)"),
    flag("geodesic-bench verify --solver mpp", "no solver named 'mpp' (did you mean 'mmp'?)"),
    flag("geodesic-bench verify --solver mmp,ich", "--solver: several are checked with --random only"),
    of("verify", "--solver mmp --seed 2", "--seed requires --random"),
    of("verify", "--random 0", "--random: "),
    of("verify", "--random 5 --meshes hill.obj", "--meshes excludes --random"),
    flag("geodesic-bench verify --solver mmp --property refusals-name-the-solvers",
         "(did you mean 'refusals-name-the-solver'?)"),
    flag("geodesic-bench verify --solver mmp --meshes hill.obj --property"
         " single-triangle-has-its-edges-for-distances", "is defined on its own meshes only"),
    flag("geodesic-bench verify --solver mmp --corpus quik", "(did you mean 'quick'?)"),
    flag("geodesic-bench verify --solver mmp --vectors sse9", "no kind of vectors named 'sse9'"),
    flag("geodesic-bench verify --solver mmp --meshes hill.obj --property"
         " repetition-gives-the-same-bits --source 4",
         "source vertex 4 is not in 'hill', which has 4 vertices"),
    of("verify", "--solver mmp --time-limit 0", "--time-limit: '0' is not greater than 0"),
    of("verify", "--solver mmp --shrink=-1", "--shrink: '-1' is not 0 or greater"),
    flag("geodesic-bench verify --solver mmp --source a --meshes hill.obj",
         "--source: 'a' is not a point"),
    flag("geodesic-bench verify --solver mmp --source edge:0-1:0.5 --meshes hill.obj",
         "--source edge:0-1:0.5: verify takes vertices, such as 12 or 12+0.5"),
    flag("geodesic-bench verify --solver mmp --source 0",
         "--source and --limit need --meshes or --corpus"),
    flag("geodesic-bench verify --solver mmp --out hill.obj", "--out 'hill.obj' is a file"),
    # compare
    flag("geodesic-bench compare old new", "geodesic-bench compare: old: no such folder"),
    flag(f"geodesic-bench compare '{GOLDEN}'", "no programs. Give two runs otherwise"),
    script("compare", "old new --margin 10%", "--margin: '10%': a margin is a ratio above 1", "1.10"),
    script("compare", "old new --levels 2", "--levels: '2': levels are 0, 1, 3 and 4"),
    # scripts
    flag("run_all.sh --fast", "run_all.sh: unknown option --fast; see run_all.sh --help"),
    flag("run_all.sh --corpus", "run_all.sh: --corpus needs a value; see run_all.sh --help"),
    flag("run_all.sh biuld", "unknown step biuld; steps are build peers fetch run check plot"),
    flag("run_tests.sh --preset fast", "unknown preset fast; presets are release ci debug"),
    flag("new_solver.sh", "give the solver a name: ./new_solver.sh my-variant"),
    flag("new_solver.sh Mine", "invalid solver name 'Mine': use lower case letters", "my-variant"),
    flag("new_solver.sh my-one --from fast", "cannot start from 'fast'; there are template"),
    flag("check_performance.sh", "the base is missing", "check_performance.sh main"),
    flag("check_performance.sh HEAD --levels 0,x", "'0,x': levels are 0, 1, 2, 3 and 4"),
    flag("check_performance.sh HEAD --margin 1,1", "'1,1': a margin is a ratio above 1, as in 1.10"),
    flag("check_performance.sh --a-a x", "'x': at least one session, as in 3"),
    flag("check_performance.sh HEAD --out /dev/null", "cannot write", "/dev/null", "--out"),
    # Python programs
    flag("fetch.py", "fetch.py: name a --corpus or meshes; see fetch.py --help"),
    flag("fetch.py --corpsu tiny", "no option named '--corpsu' (did you mean '--corpus'?); there are: ",
         "see fetch.py --help"),
    flag("fetch.py --corpus tinny", "fetch.py: no corpus named 'tinny' (did you mean 'tiny'?); there are: "),
    flag(r"fetch.py $'\e[31mred'", r"fetch.py: no mesh named '\x1b[31mred'; the nearest of "),
    flag("check_run.py --runs", "geodesic-bench check: no option named '--runs'; there are: ",
         "see geodesic-bench check --help"),
    flag("plots strip_depth --run nowhere", "geodesic-bench plot: nowhere: no such folder; ./run_all.sh run"),
    flag("report.py a b", "geodesic-bench report: unrecognized arguments: b"),
    flag("plots overview --out", "argument --out: expected one argument; see geodesic-bench plot --help"),
    flag("plots spedup", "geodesic-bench plot: no table or figure named 'spedup' (did you mean 'speedup'?)"),
]  # fmt: skip
