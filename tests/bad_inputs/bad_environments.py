"""Bad environments: disks, rights, streams, interpreters and packages with faults."""

from __future__ import annotations

from bad_results import GOLDEN
from case import Case

RUN = GOLDEN.parent
SOLVE = "geodesic-bench solve hill.obj --solver mmp --source 0"
MEASURE = (
    "geodesic-bench run --meshes hill.obj --solvers mmp --sources 1 --repetitions 1"
    " --min-time 0.00001"
)
BIG = "geodesic-bench generate icosphere --frequency 20 -o"
STREAM = ["standard output", "is it closed, or the disk full?"]
FULL = "No space left on device"
NO_PYTHON_MODULES = "as Debian's /usr/bin/python3 has them"


def full_stream(command: str, *says: str, lines: int = 1) -> Case:
    return Case(f"a full disk behind {command}", f"{command} >/dev/full", list(says), lines=lines)


def closed(command: str) -> Case:
    return Case(f"closed output of {command}", f"{command} >&-", STREAM)


CASES = [
    # Folders without room or rights
    Case("solve: a folder without rights", f"unprivileged {SOLVE} --output closed/d.txt",
         ["cannot write 'closed/d.txt': Permission denied"], given="mkdir -m 555 closed",
         needs="unprivileged"),
    Case("solve: a read-only disk", f"with-disk ro {SOLVE} --output disk/d.txt",
         ["cannot write 'disk/d.txt': Read-only file system"], needs="with-disk"),
    Case("generate: a full disk", f"with-disk size=8k {BIG} disk/a.obj",
         ["cannot write 'disk/a.obj'", FULL], needs="with-disk"),
    Case("solve: a full disk", f"with-disk size=8k {SOLVE.replace('hill.obj', 'a.obj')}"
         " --output disk/d.txt", ["cannot write 'disk/d.txt'", FULL], given=f"{BIG} a.obj",
         needs="with-disk"),
    Case("solve: a device without room", f"{SOLVE} --output /dev/full",
         ["cannot write '/dev/full'", FULL]),
    Case("run: a file in place of its folder", f"{MEASURE} --out hill.obj",
         ["cannot make the folder 'hill.obj'", "Not a directory"]),
    Case("run: a read-only disk", f"with-disk ro {MEASURE} --out disk/run",
         ["cannot make the folder 'disk/run'", "Read-only file system"], needs="with-disk"),
    Case("rank: a folder that may not be written to",
         "unprivileged geodesic-bench rank --solver mmp --against ich --meshes hill.obj"
         " --out closed/r", ["cannot make the folder 'closed/r'", "Permission denied"],
         given="mkdir -m 555 closed", needs="unprivileged"),
    Case("verify: no TMPDIR", "TMPDIR=/proc/nowhere geodesic-bench verify --solver mmp",
         ["TMPDIR"]),
    Case("fetch.py: a file in place of the cache", "fetch.py tiny-plate --cache hill.obj",
         ["cannot write to the dataset cache hill.obj", "name another with --cache"]),
    Case("fetch.py: a read-only disk", "with-disk ro fetch.py tiny-plate --cache disk",
         ["cannot write to the dataset cache disk", "Read-only file system", "--cache"],
         needs="with-disk"),
    Case("fetch.py: a full disk", "with-disk size=12k fetch.py tiny-plate --cache disk",
         ["tiny-plate: missing", FULL], code=3, needs="with-disk"),
    Case("fetch.py: an unreadable file in the cache", "unprivileged fetch.py tiny-plate --cache .",
         ["cannot read the dataset cache .", "Permission denied", "make it readable"],
         given="touch tiny-plate.ply; chmod 000 tiny-plate.ply", needs="unprivileged"),
    Case("plots strip_depth: a file in place of its folder",
         f"plots strip_depth --run '{RUN}' --out hill.obj", ["File exists: hill.obj", "--out"]),
    Case("plots strip_depth: a full disk",
         f"with-disk size=4k plots strip_depth --run '{RUN}' --out disk/t", [FULL, "--out"], needs="with-disk"),
    Case("run_tests.sh: a checkout of others", "unprivileged checkout/run_tests.sh --no-install",
         ["run_tests.sh: cannot write", "run_tests.log", "check who owns the checkout"],
         given="cp -r $CHECKOUT checkout; rm -rf checkout/build; chmod 555 checkout",
         needs="unprivileged"),
    Case("new_solver.sh: a folder that may not be written to",
         "unprivileged new_solver.sh my-one --outside closed/x",
         ["new_solver.sh: cannot make", "closed/x: Permission denied", "nothing was changed"],
         given="mkdir -m 555 closed", needs="unprivileged"),
    # Streams
    full_stream(SOLVE, *STREAM),
    full_stream("geodesic-bench list", *STREAM),
    full_stream("geodesic-bench mesh hill.obj", *STREAM),
    full_stream("geodesic-bench solve --help", *STREAM),
    full_stream(f"{MEASURE} --out run", *STREAM, lines=3),
    full_stream(f"check_run.py '{RUN}'", "geodesic-bench check: cannot write", FULL),
    full_stream(f"plots strip_depth --run '{RUN}' --out t", "geodesic-bench plot: cannot write", FULL),
    full_stream("fetch.py --help", "fetch.py: cannot write", FULL),
    full_stream("new_solver.sh --help", "write error", FULL),
    closed(SOLVE),
    closed(f"{SOLVE} --output d.txt"),
    closed("geodesic-bench --version"),
    Case("a full disk behind the errors, too", "geodesic-bench slove 2>/dev/full", [], lines=0),
    # Interpreters and packages
    Case("rank: no Python", "without-python geodesic-bench rank --solver mmp --against ich",
         ["no python3", "numpy", "was found: install"], needs="without-python"),
    Case("run_all.sh: no Python", "without-python run_all.sh fetch --no-install",
         ["run_all.sh: no python3 has", "/usr/bin/python3"], needs="without-python"),
    Case("run_all.sh: no cmake, and nothing may be installed",
         "PATH=$PWD/few checkout/run_all.sh build --no-install",
         ["run_all.sh: missing: ", "cmake", "Install with:", "sudo apt-get install"], lines=3,
         given="cp -r $CHECKOUT checkout; mkdir few; for tool in bash cat date dirname grep head id"
         " mkdir sed tail tee; do ln -s $(command -v $tool) few; done"),
    Case("check_run.py: no jsonschema", f"without jsonschema check_run.py '{RUN}'",
         ["geodesic-bench check: No module named 'jsonschema'", "python3-jsonschema", NO_PYTHON_MODULES]),
    Case("plots overview: no matplotlib", f"without matplotlib plots overview --run '{RUN}'",
         ["geodesic-bench plot: No module named 'matplotlib'", "python3-matplotlib", NO_PYTHON_MODULES]),
    Case("report.py: no jinja2", f"without jinja2 report.py '{RUN}'",
         ["geodesic-bench report: No module named 'jinja2'", "python3-jinja2", NO_PYTHON_MODULES]),
    Case("plots performance: no numpy", f"without numpy plots performance --run '{RUN}'",
         ["geodesic-bench plot: No module named 'numpy'", "python3-numpy", NO_PYTHON_MODULES]),
    Case("fetch.py: no requests", "without requests fetch.py --corpus tiny",
         ["fetch.py: No module named 'requests'", "python3-requests", NO_PYTHON_MODULES]),
    Case("fetch.py: no npm", "PATH=$PWD fetch.py dragon-raw --cache cache",
         ["dragon-raw: missing", "there is no npm: install it (Debian: npm)"], code=3,
         given="ln -s $(command -v fetch.py) fetch.py"),
    Case("fetch.py: a mirror that is none", "GEODESIC_DATASETS_MIRROR=ftp://x fetch.py horse"
         " --cache cache", ["GEODESIC_DATASETS_MIRROR is ftp://x", "file:///, http://"]),
    Case("fetch.py: a mirror without the file", "GEODESIC_DATASETS_MIRROR=$PWD fetch.py horse"
         " --cache cache", ["horse: missing: is not in the mirror: there is no"], code=3),
]  # fmt: skip
