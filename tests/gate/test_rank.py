"""Rankings of synthetic runs: order, means, ties, failures and output."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import runs
from results.reader import Run
from runs import Data, of_solvers, run

from gate import rank as command
from gate.findings import GateError
from gate.rank_report import as_json, as_latex, as_markdown, verdict
from gate.ranking import Ranking, Standing, rank


def of(data: Data, candidate: str | None = None) -> tuple[Ranking, Run]:
    made = run(data)
    return rank(made, candidate), made


def standing(ranking: Ranking, solver: str) -> Standing:
    return next(one for one in ranking.standings if one.solver == solver)


def value(ranking: Ranking, solver: str) -> float:
    time = standing(ranking, solver).time
    assert time is not None
    return time.estimate.value


def test_times_are_relative_to_the_candidate_and_the_fastest_is_the_smallest() -> None:
    ranking, made = of(of_solvers({"new": 1.0, "slow": [2.0, 8.0, 4.0], "fast": 0.25}))
    assert [(one.solver, one.rank) for one in ranking.standings] == [
        ("fast", 1), ("new", 2), ("slow", 3)
    ]  # fmt: skip
    assert value(ranking, "slow") == pytest.approx(4, rel=0.02)
    assert value(ranking, "fast") == pytest.approx(0.25, rel=0.02)
    text = as_markdown(ranking, made)
    assert "| fast | 1 | 0.2" in text and "| new | 2 | 1 | - |" in text
    assert "## horse, 48485 vertices, 1 source" in text
    assert verdict(ranking).startswith("Times relative to new on 3 meshes: fast 0.2")
    assert "correct on 3 of 3 meshes, to 1.0e-15" in verdict(ranking)


def test_a_drift_that_hits_both_sides_of_a_pair_is_no_difference() -> None:
    ranking, _ = of(of_solvers({"new": 1.0, "a": 1.1}, spread=0.0))
    time = standing(ranking, "a").time
    assert time is not None and time.resolved
    assert (time.estimate.low, time.estimate.high) == pytest.approx((1.1, 1.1))


def test_what_is_not_resolved_has_its_median_beside_a_tilde_and_shares_a_rank() -> None:
    ranking, made = of(of_solvers({"new": 1.0, "same": 1.0, "slow": 2.0}, spread=0.03))
    assert sorted((one.solver, one.rank) for one in ranking.standings) == [
        ("new", 1), ("same", 1), ("slow", 3)
    ]  # fmt: skip
    assert f"| same | 1 | ~ {value(ranking, 'same'):.3f} |" in as_markdown(ranking, made)


def test_solvers_that_tie_with_each_other_and_not_with_the_candidate_share_a_rank() -> None:
    ranking, _ = of(of_solvers({"new": 1.0, "a": 2.0, "b": 2.0}, spread=0.03))
    assert sorted(one.rank or 0 for one in ranking.standings) == [1, 2, 2]


def test_a_rank_begins_only_where_all_before_are_resolved_from_all_behind() -> None:
    ranking, _ = of(of_solvers({"new": 1.0, "a": 1.001, "b": 1.012, "slow": 2.0}, spread=0.03))

    def resolved(first: str, second: str) -> bool:
        mean = ranking.measurements.mean(first, second)
        return mean is not None and mean.resolved

    assert resolved("new", "b") and not resolved("new", "a") and not resolved("a", "b")
    assert [(one.solver, one.rank) for one in ranking.standings] == [
        ("new", 1), ("a", 1), ("b", 1), ("slow", 4)
    ]  # fmt: skip


def test_solvers_of_different_ranks_are_resolved_in_their_order_on_the_meshes_of_both() -> None:
    """The mean of b is lower only because it lacks the mesh on which all others are slow."""
    one = fail("b", "horse", "unsupported")
    ranking, _ = of(of_solvers({"new": 1.0, "a": [9.0, 2.0, 2.0], "b": [1.0, 2.5, 2.5]}, change=one))
    assert value(ranking, "b") < value(ranking, "a")
    mean = ranking.measurements.mean("a", "b")
    assert mean is not None and mean.resolved and mean.estimate.low > 1
    assert [(one.solver, one.rank) for one in ranking.standings] == [("new", 1), ("b", 2), ("a", 2)]


def test_solvers_without_a_common_mesh_share_a_rank() -> None:
    def change(rows: list[Data]) -> None:
        for solver, mesh in (("a", "horse"), ("b", "rocker-arm"), ("b", "flat-grid")):
            fail(solver, mesh, "unsupported")(rows)

    ranking, _ = of(of_solvers({"new": 1.0, "a": 2.0, "b": 3.0}, change=change))
    assert ranking.measurements.mean("a", "b") is None
    assert [one.rank for one in ranking.standings] == [1, 2, 2]


@pytest.mark.parametrize("candidate", ["new", "a", "b", "c"])
def test_a_solver_that_is_not_resolved_from_the_candidate_has_its_rank(candidate: str) -> None:
    for seed in range(8):
        near = np.random.default_rng(seed).normal(1, 0.01, (4, 3)).tolist()
        ranking, _ = of(of_solvers(dict(zip(("new", "a", "b", "c"), near, strict=True)), 0.02, 9), candidate)
        ranks = [one.rank for one in ranking.standings if one.time is None or not one.time.resolved]
        assert len(set(ranks)) == 1


def test_too_few_pairs_have_neither_intervals_nor_ranks() -> None:
    ranking, made = of(of_solvers({"new": 1.0, "a": 2.0}, pairs=1))
    text = as_markdown(ranking, made)
    assert "| a | - | ~ 2.0" in text and "A rank begins" not in text and "fewer than 6 pairs resolve nothing" in text
    assert " to " not in text.split("## horse")[1].split("\n\n")[1]
    assert json.loads(as_json(ranking))["standings"][1]["time"]["low"] is None


def fail(solver: str, mesh: str, outcome: str) -> Any:
    def change(rows: list[Data]) -> None:
        rows[:] = [r for r in rows if (r["solver"], r["mesh"]) != (solver, mesh)]
        rows.append(runs.failed(solver, mesh, outcome))

    return change


def test_a_solver_that_cannot_do_a_mesh_is_left_out_of_its_mean_and_a_remark_says_so() -> None:
    data = of_solvers({"new": 1.0, "a": [2.0, 2.0, 9.0], "b": 2.0},
                      change=fail("a", "flat-grid", "unsupported"))  # fmt: skip
    ranking, made = of(data)
    assert value(ranking, "a") == pytest.approx(2, rel=0.02)
    assert standing(ranking, "a").right == 2
    assert "without a time: a on flat-grid: unsupported: vertex 7 is off" in ranking.remarks
    assert any(line.startswith("the means of a are over 2 of 3 meshes") for line in ranking.remarks)
    assert "| a | unsupported |" in as_markdown(ranking, made)
    assert "on 2 meshes, b" in verdict(ranking) or "on 2 meshes." in verdict(ranking)


def test_remarks_that_are_alike_are_one_with_the_solvers_and_meshes() -> None:
    def change(rows: list[Data]) -> None:
        for mesh in ("horse", "flat-grid"):
            fail("a", mesh, "unsupported")(rows)
            fail("b", mesh, "unsupported")(rows)

    ranking, _ = of(of_solvers({"new": 1.0, "a": 2.0, "b": 4.0}, change=change))
    assert ranking.remarks == [
        "without a time: a, b on horse, flat-grid: unsupported: vertex 7 is off",
        "the means of a, b are over 1 of 3 meshes: compare them only with means over the same meshes",
    ]


def test_a_wrong_answer_has_no_time_and_comes_first() -> None:
    ranking, _ = of(of_solvers({"new": 1.0, "a": 2.0}, change=fail("new", "horse", "wrong answer")))
    assert len(standing(ranking, "a").meshes) == 2
    assert verdict(ranking).startswith("WRONG ANSWERS of new")
    assert "correct on 2 of 3 meshes" in verdict(ranking)


def test_a_failure_in_a_later_pair_takes_the_times_of_its_mesh() -> None:
    def crash(rows: list[Data]) -> None:
        row = next(r for r in rows if r["solver"] == "a" and r["repetition_index"] == 7)
        rows[:] = [r for r in rows if r["mesh"] != "horse" or r["solver"] != "a"
                   or r["repetition_index"] < 7]  # fmt: skip
        rows.append({**runs.failed("a", row["mesh"], "crashed"), "repetition_index": 7})

    ranking, _ = of(of_solvers({"new": 1.0, "a": 2.0}, change=crash))
    assert [on.mesh for on in standing(ranking, "a").meshes] == ["rocker-arm", "flat-grid"]


def test_any_solver_of_the_run_can_be_the_candidate() -> None:
    ranking, _ = of(of_solvers({"new": 1.0, "a": 2.0}), "a")
    assert value(ranking, "new") == pytest.approx(0.5, rel=0.02)
    with pytest.raises(GateError, match="has no solver b; it has new, a"):
        of(of_solvers({"new": 1.0, "a": 2.0}), "b")
    with pytest.raises(GateError, match="not an interleaved run"):
        of(runs.separate(1.0))


def test_latex_has_both_tables_and_the_figure() -> None:
    ranking, made = of(of_solvers({"new": 1.0, "a-b": 2.0}))
    text = as_latex(ranking, made)
    assert text.count("\\toprule") == 2 and "a-b" in text and "[width=\\linewidth]{rank.pdf}" in text


def test_the_ranking_is_derived_again_without_measuring(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "run.json").write_text(json.dumps(of_solvers({"new": 1.0, "a": 2.0})))
    before = (tmp_path / "run.json").read_bytes()
    assert command.main(["--run", str(tmp_path)]) == 0
    written = capsys.readouterr()
    assert written.out.startswith("# new against a\n")
    assert (tmp_path / "rank.md").read_text("utf-8").startswith(written.out)
    assert {file.name for file in tmp_path.iterdir()} == {
        "run.json", "rank.md", "rank.tex", "rank.json", "rank.pdf", "rank.png"
    }  # fmt: skip
    assert (tmp_path / "run.json").read_bytes() == before


def test_the_run_takes_the_options_of_the_ranking(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GEODESIC_BENCH", "bench")
    monkeypatch.setenv("GEODESIC_PLUGINS", '["--plugin", "p.so"]')
    options = command.parse(["--solver", "a", "--against", "b,c", "--meshes", "x.obj", "--pairs",
                             "7", "--seed", "3"])  # fmt: skip
    words = " ".join(command.run_command(options, Path("out")))
    assert words.startswith("bench --plugin p.so run --interleave --solvers a,b,c --repetitions 7")
    assert "--meshes x.obj" in words and "--seed 3" in words and "--corpus" not in words
    again = command.parse(["--resume", "out"])
    assert command.run_command(again, Path("out")) == [
        "bench", "--plugin", "p.so", "run", "--resume", "out"
    ]  # fmt: skip
