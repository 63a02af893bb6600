"""Tables and the figure about public codes: costs of answers, twins, robustness, break-even."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pytest
import synthetic
from synthetic import Data, data_of, mesh, solver, with_rows

from plots import answers, break_even, peers_overview, robustness, twins
from results.reader import Mesh, ResultError, Run, Skip
from results.table import Field, Table

SOLVERS = {
    name: solver(name, exactness, error_bound=0.01)
    for name, exactness in [
        ("edge-based", "exact"), ("vtp", "exact"), ("gc-heat", "unbounded"), ("avtp", "bounded"),
    ]
}  # fmt: skip
MESHES = {"knot-1k": mesh("knot-1k", 1000), "knot-100k": mesh("knot-100k", 100_000)}


def row(of: str, on: str = "knot-1k", source: int = 0, **numbers: float) -> Data:
    return synthetic.row(of, on, source, reference="brute force", prepare_time=1.0) | numbers


def failed(solver: str, mesh: str, outcome: str, source: int | str = 0, **data: Any) -> Data:
    cell = {"solver": solver, "mesh": mesh, "source": source, "outcome": outcome}
    return cell | {"error_message": f"{outcome}, said {solver}"} | data


def run_of(rows: list[Data], meshes: Mapping[str, Mesh] = MESHES) -> Run:
    run = synthetic.run_of(SOLVERS.values(), (), rows, time_limit=10)
    return replace(run, meshes=dict(meshes), sources={name: [0, 1] for name in meshes})


def fields(table: Table, **where: str) -> dict[str, Field]:
    """Returns the fields of the first row with these texts, by column."""
    for line in table.rows:
        named = dict(zip(table.header, line, strict=True))
        if all(named[key].text == text for key, text in where.items()):
            return named
    raise AssertionError(f"no row with {where} in {table.name}")


def of_solver(table: Table, solver: str) -> dict[str, Field]:
    return fields(table, Solver=solver)


# ---- what an answer costs


def test_the_first_answer_is_preparation_and_solve_and_a_further_one_renewal_and_solve() -> None:
    rows = [row("edge-based", cpu_time=8), row("vtp", prepare_time=30, renew_time=5, cpu_time=12)]
    vtp = of_solver(answers.table(run_of(rows)), "vtp")
    assert vtp["First answer"].text == "42.0 [42.0, 42.0] ms" and vtp["Each further"].text == "17.0 [17.0, 17.0] ms"
    assert vtp["/ edge-based"].value == pytest.approx(42 / 9)
    assert vtp["/ edge-based, further"].value == pytest.approx(17 / 8)


def test_several_threads_are_timed_by_the_wall() -> None:
    rows = [row("edge-based"), row("vtp", threads=2, cpu_time=20, real_time=10, prepare_time=0)]
    assert of_solver(answers.table(run_of(rows)), "vtp")["First answer"].text == "10.0 [10.0, 10.0] ms"


def test_ratios_are_paired_by_source() -> None:
    rows = [
        row(solver, source=source, prepare_time=0, cpu_time=slow * times)
        for source, slow in [(0, 1), (1, 100)]
        for solver, times in [("edge-based", 1), ("vtp", 3)]
    ]
    ratio = of_solver(answers.table(run_of(rows)), "vtp")["/ edge-based"]
    assert (ratio.value, ratio.low, ratio.high) == pytest.approx((3, 3, 3))


def test_errors_are_the_largest_and_the_middle_mean_and_wrong_answers_have_them_too() -> None:
    rows = [
        row("edge-based"),
        row("gc-heat", source=0, max_relative_error=0.5, mean_relative_error=0.01),
        row("gc-heat", source=1, max_relative_error=0.9, mean_relative_error=0.03),
        failed("vtp", "knot-1k", "wrong answer", max_relative_error=0.017,
               mean_relative_error=1e-5),
    ]  # fmt: skip
    table = answers.table(run_of(rows))
    heat, vtp = (of_solver(table, solver) for solver in ("gc-heat", "vtp"))
    assert heat["Largest error"].value == 0.9 and heat["Mean error"].value == pytest.approx(0.02)
    assert (heat["Promise"].text, heat["Outcome"].text) == ("unbounded", "ok")
    assert (vtp["Outcome"].text, vtp["First answer"].text) == ("wrong answer", "")
    assert "wrong answer, said vtp" in vtp["Outcome"].note
    assert (vtp["Largest error"].text, vtp["Mean error"].text) == ("1.7e-02", "1.0e-05")


def test_the_fastest_first_answer_stands_first_and_failures_last() -> None:
    rows = [failed("vtp", "knot-1k", "crashed"), row("edge-based", cpu_time=5), row("gc-heat")]
    table = answers.table(run_of(rows, {"knot-1k": MESHES["knot-1k"]}))
    assert [line[1].text for line in table.rows] == ["gc-heat", "edge-based", "vtp"]


# ---- twins


def test_twins_are_compared_by_time_and_by_the_windows_that_both_count() -> None:
    rows = [
        row("edge-based", cpu_time=2, window_propagations=100),
        row("vtp", cpu_time=12, window_propagations=130),
        row("edge-based", "knot-100k", cpu_time=10, window_propagations=1000),
        row("vtp", "knot-100k", cpu_time=15),
    ]
    table = twins.table(run_of(rows))
    small, large = (fields(table, Mesh=mesh) for mesh in MESHES)
    assert small["Time / ours"].value == pytest.approx(6)
    assert small["/ ours"].value == pytest.approx(1.3)
    assert (large["Windows"].text, large["/ ours"].text) == ("\N{EM DASH}", "\N{EM DASH}")
    assert fields(table, Mesh=twins.ALL)["Time / ours"].value == pytest.approx(3)  # sqrt(6 * 1.5)
    (line,) = twins.overall(run_of(rows)).rows
    assert [line[i].value for i in (2, 3)] == pytest.approx([3, 1.3])
    assert line[4].text == "2 of 2"


def test_a_twin_that_fails_is_shown_with_its_outcome() -> None:
    rows = [row("edge-based"), failed("vtp", "knot-1k", "time-out")]
    only = {"knot-1k": MESHES["knot-1k"]}
    assert fields(twins.table(run_of(rows, only)), Mesh="knot-1k")["Time / ours"].text == "time-out"


def test_without_a_twin_there_is_no_table() -> None:
    with pytest.raises(ResultError, match=r"run\.json: no solver of ours beside a public code"):
        twins.table(run_of([row("edge-based"), row("gc-heat")]))


# ---- which solver is right on which case

REPORT = "https://github.com/libigl/libigl/issues/2554"
CASES = {
    "apart": replace(MESHES["knot-1k"], name="apart", why="two parts", reports=(REPORT,)),
    "pinched": replace(MESHES["knot-1k"], name="pinched", why="two sheets"),
}


def case_run() -> Run:
    return run_of(
        [
            row("edge-based", "apart"), row("edge-based", "pinched"),
            failed("vtp", "apart", "wrong answer", unreachable_mismatches=3),
            row("vtp", "pinched", source=0), failed("vtp", "pinched", "crashed", source=1),
            row("gc-heat", "apart", max_relative_error=0.25),
            failed("gc-heat", "pinched", "unsupported"),
            row("avtp", "apart", max_relative_error=0.001),
            failed("avtp", "pinched", "wrong answer", max_relative_error=0.5),
        ],
        CASES,
    )  # fmt: skip


def test_the_matrix_has_a_word_for_every_solver_and_case() -> None:
    table = robustness.matrix(case_run())
    apart, pinched = (fields(table, Case=case) for case in CASES)
    shown = {s: (apart[s].text, pinched[s].text) for s in SOLVERS}
    assert shown == {
        "edge-based": ("right", "right"),
        "vtp": ("wrong: reach of 3", "crash"),
        "gc-heat": ("off: 2.5e-01", "unsupported"),
        "avtp": ("right", "wrong: 5.0e-01"),
    }


def test_a_solver_of_single_sources_is_not_judged_by_sets() -> None:
    single = [row("vtp", "apart"), failed("vtp", "apart", "unsupported", source="boundary")]
    none = [failed("vtp", "pinched", "unsupported"),
            failed("vtp", "pinched", "unsupported", source="boundary")]  # fmt: skip
    table = robustness.matrix(run_of([row("edge-based", "apart"), *single, *none], CASES))
    assert [fields(table, Case=case)["vtp"].text for case in CASES] == ["right", "unsupported"]


@pytest.mark.parametrize(
    ("ended", "word"),
    [
        (failed("vtp", "apart", "wrong answer", max_relative_error=2e-9), "imprecise: 2.0e-09"),
        (failed("vtp", "apart", "wrong answer", max_relative_error=2e-9, unreachable_mismatches=1),
         "wrong: reach of 1"),
        (failed("vtp", "apart", "error"), "refused"),
        (failed("vtp", "apart", "error", error_message="exit code 1"), "exits"),
        (failed("vtp", "apart", "time-out"), "hang"),
        (failed("vtp", "apart", "out of memory"), "out of memory"),
        (failed("vtp", "apart", "skipped"), "skipped"),
    ],
)  # fmt: skip
def test_an_end_has_its_word(ended: Data, word: str) -> None:
    run = run_of([row("edge-based", "apart"), row("vtp", "apart", source=1), ended], CASES)
    assert fields(robustness.matrix(run), Case="apart")["vtp"].text == word


def test_a_case_says_what_it_stands_for_and_who_reported_it() -> None:
    table = robustness.matrix(case_run())
    apart, pinched = (fields(table, Case=case) for case in CASES)
    assert apart["Reported of"].text == "libigl 2554"
    assert apart["Case"].note == f"apart: two parts ({REPORT})."
    assert (pinched["Reported of"].text, pinched["Case"].note) == (
        "\N{EM DASH}", "pinched: two sheets.",
    )  # fmt: skip


def test_the_cases_of_each_word_are_counted() -> None:
    table = robustness.counts(case_run())
    assert table.header[2:] == ["Right", "Off", "Unsupported", "Wrong", "Crash"]
    assert {line[0].text: [c.value for c in line[2:]] for line in table.rows} == {
        "edge-based": [2, 0, 0, 0, 0],
        "vtp": [0, 0, 0, 1, 1],
        "gc-heat": [0, 1, 1, 0, 0],
        "avtp": [1, 0, 0, 1, 0],
    }


def test_a_hang_is_told_with_the_limit_and_the_slowest_answer() -> None:
    (remark,) = robustness.matrix(case_run()).remarks
    assert remark.endswith("no answer within 10 s; the slowest of all answers took 2.00 ms.")


def test_failures_are_listed_with_what_happened() -> None:
    listed = [[c.text for c in line] for line in robustness.failures(case_run()).rows]
    assert listed == [
        ["apart", "vtp", "0", "wrong", "wrong answer, said vtp"],
        ["pinched", "vtp", "1", "crash", "crashed, said vtp"],
        ["pinched", "avtp", "0", "wrong", "wrong answer, said avtp"],
    ]


def test_a_skipped_case_and_one_without_rows_are_told() -> None:
    run = run_of([row("edge-based", "apart")], CASES)
    assert fields(robustness.matrix(run), Case="pinched")["edge-based"].text == "missing"
    skipped = replace(run, skipped=[Skip("pinched", None, "no file")])
    assert fields(robustness.matrix(skipped), Case="pinched")["edge-based"].text == "skipped"


def test_meshes_that_nobody_reported_on_are_no_cases() -> None:
    with pytest.raises(ResultError, match="run --corpus robustness"):
        robustness.matrix(run_of([row("edge-based")]))


# ---- break-even


@pytest.mark.parametrize(
    ("preparations", "furthers", "sources"),
    [((10, 2), (1, 3), 4), ((2, 10), (1, 3), 0), ((10, 2), (3, 1), math.inf)],
)
def test_both_have_taken_the_same_time_after_the_break_even(
    preparations: tuple[float, float], furthers: tuple[float, float], sources: float
) -> None:
    found = break_even.break_even(preparations, furthers)
    assert found == sources
    if 0 < found < math.inf:
        heat, exact = (p + found * f for p, f in zip(preparations, furthers, strict=True))
        assert heat == pytest.approx(exact)


def heat_run() -> Run:
    return heat_run_beside([])


def heat_run_beside(others: list[Data]) -> Run:
    """Break-even at 4.5 sources on the small mesh. On the large mesh the exact solver is always faster."""
    errors: Data = {"max_relative_error": 0.9, "mean_relative_error": 0.04}
    return run_of(
        [
            row("edge-based", prepare_time=1, cpu_time=3),
            row("gc-heat", prepare_time=10, cpu_time=1, **errors),
            row("edge-based", "knot-100k", prepare_time=1, cpu_time=3),
            row("gc-heat", "knot-100k", prepare_time=10, cpu_time=4, **errors),
            *others,
        ]
    )


def test_break_even_stands_by_mesh_with_the_error_beside_it() -> None:
    table = break_even.table(heat_run())
    small, large = (fields(table, Mesh=mesh) for mesh in MESHES)
    assert small["Break-even (sources)"].text == "4.5 [4.5, 4.5]"
    assert large["Break-even (sources)"].text == "never"
    assert (small["Mean error"].value, small["Largest error"].value) == (0.04, 0.9)


def test_the_caption_says_from_how_many_sources_on() -> None:
    drawn = break_even.figure(heat_run())
    assert (
        "gc-heat is faster than edge-based from 5 sources at 1,000 vertices and no number of "
        "sources at 100,000 vertices on, with a mean error of up to 4%." in drawn.caption
    )


def test_solvers_whose_preparation_is_shorter_than_an_exact_answer_have_no_break_even() -> None:
    quick: Data = {"prepare_time": 2, "cpu_time": 1, "max_relative_error": 0.9}
    run = heat_run_beside([row("quick", mesh, **quick) for mesh in MESHES])
    assert {row[0].text for row in break_even.table(run).rows} == {"gc-heat"}


def test_one_mesh_has_no_break_even_over_size() -> None:
    run = heat_run().of_meshes(["knot-1k"])
    with pytest.raises(ResultError, match="run --corpus break-even --peers all"):
        break_even.figure(run)


# ---- own solvers and public codes in one figure


def peers_run(**ours: Any) -> Run:
    rows = [
        *(row(s, mesh, cpu_time=10) for s in ("edge-based",) for mesh in MESHES),
        row("vtp", cpu_time=20, prepare_time=5),
        row("gc-heat", cpu_time=2, prepare_time=50, max_relative_error=0.2, mean_relative_error=0.03),
    ]
    plugins = [{"file": f"/some/where/peers/{n}/lib{n}.so", "solvers": [n]} for n in ("vtp", "gc-heat")]
    context = {"plugins": plugins, "started": "2026-01-02T03:04:05Z", "processor": "P", "corpus": "standard",
               "command": "geodesic-bench run --corpus standard --plugin /some/where/libvtp.so --sources 2"}  # fmt: skip
    return replace(run_of(rows), context={"geodesic_bench": context | ours})


def test_the_picture_of_peers_has_preparation_errors_and_the_meshes_that_are_lacking() -> None:
    drawn = peers_overview.figure(peers_run())
    axes = drawn.figure.axes[0]
    assert [tick.get_text() for tick in axes.get_yticklabels()] == ["edge-based", "vtp", "gc-heat"]
    texts = [text.get_text() for text in axes.texts]
    assert texts[2::2] == ["2.27", "4.73"]  # (20 + 5) / (10 + 1), (2 + 50) / (10 + 1)
    assert texts[3::2] == [
        "exact; on 1 of 2 meshes", "errors: mean 3%, largest 20%; on 1 of 2 meshes"
    ]  # fmt: skip


def test_the_picture_of_peers_says_when_on_what_and_how_it_was_measured() -> None:
    words = "2026-01-02, P, 2 meshes: ./run_all.sh --corpus standard --sources 2 --peers vtp,gc-heat"
    drawn = peers_overview.figure(peers_run())
    assert words in drawn.caption and "/some/where" not in drawn.caption
    assert " ".join(drawn.figure._supxlabel.get_text().split()) == words


@pytest.mark.parametrize(
    ("recorded", "printed"),
    [
        ("./run_all.sh --meshes 'a b' --external 'mine=m {mesh}' --out x --sources 2",
         "./run_all.sh --meshes 'a b' --external 'mine=m {mesh}' --sources 2"),
        ("/usr/bin/geodesic-bench run --corpus quick --plugin libvtp.so --solvers mmp,vtp,gc-heat?time=2 --out=y",
         "./run_all.sh --corpus quick --solvers mmp --peers vtp,gc-heat"),
        ("geodesic-bench --plugin libvtp.so run suite.json --sources 2",
         "./run_all.sh --corpus standard --sources 2 --peers vtp,gc-heat"),
    ],
)  # fmt: skip
def test_the_command_of_a_run_can_be_given_again(recorded: str, printed: str) -> None:
    assert peers_overview.command(peers_run(command=recorded)) == printed


def test_the_command_of_a_merged_run_is_a_part_s_without_its_number() -> None:
    parts = [{"command": f"geodesic-bench run --corpus quick --shard {k}/2 --out {k}"} for k in (1, 2)]
    run = peers_run(command="geodesic-bench merge 1 2 --out all", parts=parts, plugins=[])
    assert peers_overview.command(run) == "./run_all.sh --corpus quick"


def test_solvers_that_the_picture_of_peers_leaves_out_are_named() -> None:
    assert "Left out" not in peers_overview.figure(peers_run()).caption
    rows = [one for one in data_of(peers_run()) if one["solver"] != "gc-heat"]
    run = with_rows(peers_run(), [*rows, failed("gc-heat", "knot-1k", "time-out")])
    assert "Left out: gc-heat, with times on few of the meshes or none." in peers_overview.figure(run).caption


def test_a_run_without_public_codes_has_no_picture_of_them() -> None:
    with pytest.raises(ResultError, match="no solver of others: ./run_all.sh --peers all"):
        peers_overview.figure(peers_run(plugins=[]))
