"""A published run has no folders of its author, has all numbers, and passes the check."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from test_check_result import Data, ours, result as result, write

from gate import check_result, publish
from results import checksum
from results.text import read_text

HOME = "/home/ada/my scans"


@pytest.fixture
def run_file(result: Data, tmp_path: Path) -> Path:
    """File of a run with folders in every text that may contain one."""
    result["context"] |= {"host_name": "ada-laptop", "executable": f"{HOME}/bin/geodesic-bench"}
    ours(result)["command"] = (
        f"'{HOME}/bin/geodesic-bench' run --meshes '{HOME}/a.ply,{HOME}/b.ply' --program 'x={HOME}/c'"
        " --plugin /opt/peers/vtp/libvtp.so --out results/runs/mine"
    )
    ours(result)["plugins"] = [
        {"file": "/opt/peers/vtp/libvtp.so", "sha256": 64 * "0", "solvers": ["vtp"]}
    ]
    ours(result)["skipped"].append(
        {"mesh": "b", "solver": None, "why": f"{HOME}/b.ply: no faces (https://example.org/b.ply)"}
    )
    result["benchmarks"][0]["recordings"] = "recordings/horse/src0/mmp"
    return write(tmp_path / "run.json", result)


def publish_run(file: Path, *more: str) -> tuple[int, Path]:
    out = file.with_name("published.json.gz")
    return publish.main([str(file.parent), "--output", str(out), *more]), out


def test_no_folder_and_no_host_is_left_and_every_number_is(run_file: Path, result: Data) -> None:
    code, out = publish_run(run_file)
    text = read_text(out)
    assert code == 0
    assert not [word for word in ("ada", "my scans", "/opt", "/bin", "recordings/") if word in text]
    data: Any = json.loads(text)
    assert ours(data)["command"] == (
        "geodesic-bench run --meshes a.ply,b.ply --program x=c --plugin libvtp.so --out results/runs/mine"
    )
    assert ours(data)["plugins"][0]["file"] == "vtp/libvtp.so"
    assert ours(data)["skipped"][-1]["why"] == "b.ply: no faces (https://example.org/b.ply)"
    del result["benchmarks"][0]["recordings"]
    assert data["benchmarks"] == result["benchmarks"]


def test_a_command_with_an_apostrophe_that_is_not_quoted_has_no_folder_either(
    run_file: Path, result: Data
) -> None:
    ours(result)["command"] = "geodesic-bench run --meshes /home/ada/it's mine/a.ply --sources 2"
    write(run_file, result)
    code, out = publish_run(run_file)
    assert code == 0 and "/home" not in read_text(out)


def test_what_is_written_passes_and_is_not_written_over(
    run_file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, out = publish_run(run_file)
    assert code == 0 and publish.NEXT in capsys.readouterr().out
    assert check_result.main([str(out)]) == 0
    assert checksum.stated(read_text(out)) == checksum.computed(read_text(out))
    assert publish_run(run_file)[0] == 1 and "is there already" in capsys.readouterr().err


def test_a_mesh_of_ones_own_needs_a_licence(
    result: Data, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = json.dumps(result).replace('"horse"', '"scan"').replace("/horse/", "/scan/")
    file = write(tmp_path / "run.json", json.loads(text))
    code, out = publish_run(file)
    assert code == 1 and not out.exists()
    assert "FAILED: scan: is not in datasets/manifest.json: geodesic-bench publish --licence 'scan=TEXT'" in (
        capsys.readouterr().out
    )
    code, out = publish_run(file, "--licence", "scan=CC BY 4.0, by Ada")
    assert code == 0 and ours(json.loads(read_text(out)))["meshes"][0]["licence"] == "CC BY 4.0, by Ada"


def test_what_would_be_refused_is_not_written(
    result: Data, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    ours(result)["modified"] = True
    code, out = publish_run(write(tmp_path / "run.json", result))
    assert code == 1 and not out.exists() and "the sources were modified" in capsys.readouterr().out
    for words, says in (("cow=free", "no mesh cow"), ("cow", "not MESH=TEXT")):
        try:
            assert publish_run(tmp_path / "run.json", "--licence", words)[0] == 1
        except SystemExit as ended:
            assert ended.code == 1
        assert says in capsys.readouterr().err
