"""The first sentences of a report and of the terminal output, and the ratios in both."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from synthetic import Changed, of_solvers

from gate import check_run
from plots import headline, report, summary
from plots.ratios import fastest_exact, mean, over_each_mesh, over_meshes, time_over
from results import outcomes
from results.reader import Run, read_run


def with_times(factor: Callable[[dict[str, Any]], float]) -> Callable[[dict[str, Any]], None]:
    def change(data: dict[str, Any]) -> None:
        for row in data["benchmarks"]:
            if row["outcome"] == "ok":
                row["cpu_time"] *= factor(row)

    return change


def test_the_fastest_exact_solver_is_compared_with_the_next_one_and_with_mmp(golden_run: Run) -> None:
    assert headline.sentences(golden_run)[0] == (
        "edge-based is 1.79 times as fast as fwp-mmp, the fastest of the other exact solvers, and "
        "is 5.0 times as fast as mmp, over 3 meshes."
    )


def test_without_mmp_the_slowest_is_named_with_the_meshes_that_it_has(golden_run: Run) -> None:
    run = of_solvers(golden_run, "edge-based", "ich", "ch")
    assert headline.sentences(run)[0] == (
        "edge-based is 5.1 times as fast as ich, the fastest of the other exact solvers, over 3 "
        "meshes, and is 20 times as fast as ch, on 1 of 3 meshes."
    )


def test_the_only_solver_is_compared_with_none(golden_run: Run) -> None:
    first, *_ = headline.sentences(of_solvers(golden_run, "mmp"))
    assert first == "mmp is the only exact solver with a verified time, over 3 meshes."
    assert "/" not in first


def test_inexact_solvers_alone_are_not_called_exact(golden_run: Run) -> None:
    run = of_solvers(golden_run, "dijkstra")
    first, *others = headline.sentences(run)
    assert first == (
        "No exact solver has a verified time. dijkstra is the only solver with a verified time, over "
        "3 meshes."
    )
    assert not any("exact" in sentence for sentence in others)


def test_a_run_without_a_verified_answer_has_one_sentence_and_tables(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        for row in data["benchmarks"]:
            row.update(outcome="crashed", error_occurred=True, error_message="signal 9")

    run = read_run(changed(change))
    assert headline.sentences(run) == ["No answer of the run is verified, so that it has no times."]
    assert fastest_exact(run) == ""
    assert {row[5].text for row in summary.overall(run).rows} == {"0"}


def test_two_solvers_that_take_the_same_time_are_not_ranked(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        mine = {
            (r["mesh"], r["source"], r["repetition_index"]): r["cpu_time"]
            for r in data["benchmarks"]
            if r["solver"] == "edge-based"
        }
        for row in data["benchmarks"]:
            if row["solver"] == "fwp-mmp":
                key = (row["mesh"], row["source"], row["repetition_index"])
                row["cpu_time"] = mine[key] * (1.01 if row["repetition_index"] else 0.991)

    first, *_ = headline.sentences(read_run(changed(change)))
    assert first.startswith("The run does not resolve which of edge-based and fwp-mmp is faster (ratio 1.0")
    assert first.endswith("; edge-based is 5.0 times as fast as mmp, over 3 meshes.")


def test_ratios_are_to_the_fastest_exact_solver_whichever_it_is(changed: Changed) -> None:
    fast = with_times(lambda row: 0.1 if row["solver"] == "mmp" else 1)
    run = read_run(changed(fast))
    assert headline.sentences(run)[0].startswith("mmp is 2.0 times as fast as edge-based")
    assert summary.overall(run).header[1] == "Time / mmp"
    assert summary.by_mesh(run).header[2] == "mmp, time"


def test_a_solver_that_is_fast_on_few_meshes_is_not_the_one_to_compare_with(changed: Changed) -> None:
    fast = with_times(lambda row: 1e-3 if row["solver"] == "ch" else 1)
    assert fastest_exact(read_run(changed(fast))) == "edge-based"


def test_errors_of_inexact_solvers_and_failures_are_told(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        for row in data["benchmarks"]:
            if row["solver"] == "dijkstra":
                row["max_relative_error"] = 0.29

    sentences = headline.sentences(read_run(changed(change)))
    assert (
        "Not exact: dijkstra is 8.5 times as fast as edge-based, with errors of up to 29%, over 3 "
        "meshes." in sentences
    )
    assert "3 answers failed or missing; not measured: stanford-bunny." in sentences


def test_the_fastest_exact_public_code_is_named_and_preparation_is_not_left_out(
    golden_run: Run, changed: Changed
) -> None:
    def change(data: dict[str, Any]) -> None:
        data["context"]["geodesic_bench"]["plugins"] = [
            {"file": f"/peers/{n}/lib{n}.so", "sha256": "0" * 64, "solvers": [n]} for n in ("ich", "fwp-ch", "dijkstra")
        ]
        for row in data["benchmarks"]:
            if row["solver"] == "dijkstra":
                row["prepare_time"] = 3000

    sentences = headline.sentences(read_run(changed(change)))
    assert (
        "Of the exact solvers of others, fwp-ch is the fastest: edge-based is 3.0 times as fast as it, on 2 of "
        "3 meshes." in sentences
    )
    assert "times as fast as edge-based, but takes 206 times the time of edge-based with its preparation, over 3 meshes." in sentences[2]
    assert not any("public" in sentence for sentence in headline.sentences(golden_run))


def test_the_thesis_is_agreed_with_or_not_as_the_times_have_it(
    golden_run: Run, changed: Changed
) -> None:
    agreed = "the order by time is the thesis's: edge-based, fwp-mmp, fwp-ch, mmp, ich"
    assert agreed in headline.sentences(golden_run)[-1]
    slow = with_times(lambda row: 9 if row["solver"] == "fwp-mmp" else 1)
    assert (
        "edge-based is the fastest as in the thesis; then come fwp-ch, mmp, ich, fwp-mmp, in the "
        "thesis fwp-mmp, fwp-ch, mmp, ich"
    ) in headline.sentences(read_run(changed(slow)))[-1]
    assert "thesis" not in " ".join(headline.sentences(golden_run.of_meshes(["flat-grid"])))
    stand_in = headline.sentences(golden_run.of_meshes(["rocker-arm"]))[-1]
    assert stand_in.startswith("On stand-ins for rocker arm, the order by time is the thesis's")


def test_terminal_and_report_have_the_same_sentences_and_numbers(
    golden_run: Run, capsys: pytest.CaptureFixture[str]
) -> None:
    check_run.main([str(golden_run.file.parent)])
    printed = capsys.readouterr().out
    page = report.page(golden_run, {"summary_by_mesh": summary.by_mesh(golden_run)}, {})
    for sentence in headline.sentences(golden_run):
        assert sentence in printed
        assert sentence.replace("'", "&#39;") in page
    for row in summary.overall(golden_run).rows:
        assert row[1].text in printed
    assert "Every solver on every mesh" in printed and "295.15 ms" not in printed


def test_of_many_meshes_means_are_those_of_few(golden_run: Run) -> None:
    for solver, ratios in over_each_mesh(golden_run, "edge-based").items():
        found = over_meshes(time_over("edge-based"), golden_run, list(golden_run.meshes), solver)
        assert found and np.isclose(found.estimate.value, mean(ratios), rtol=1e-12)


def test_the_cells_that_a_solver_declares_to_be_beyond_it_have_one_line(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        for row in data["benchmarks"]:
            if row["solver"] == "ch":
                row.update(outcome="unsupported", error_occurred=True, error_message="too large")

    run = read_run(changed(change))
    assert outcomes.reasons(run)["ch", "unsupported"] == (
        "ch: unsupported, as declared, on 2 meshes, 3 cells (rocker-arm, flat-grid): too large"
    )
    assert sum("ch: unsupported" in note for note in summary.every(run).notes()) == 1
