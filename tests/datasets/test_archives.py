"""Taking a mesh out of an archive, whatever the archive holds."""

from __future__ import annotations

import gzip
import io
import stat
import tarfile
import zipfile
from collections.abc import Callable

import pytest
from fetch_world import TRIANGLE, World, downloaded, sha256
from fetching import archive


def zip_of(members: dict[str, bytes]) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as opened:
        for name, data in members.items():
            opened.writestr(name, data)
    return packed.getvalue()


def zip_with_link(name: str, target: str) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as opened:
        link = zipfile.ZipInfo(name)
        link.external_attr = (stat.S_IFLNK | 0o777) << 16
        opened.writestr(link, target)
    return packed.getvalue()


def tgz_of(members: dict[str, bytes]) -> bytes:
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w:gz") as opened:
        for name, data in members.items():
            info = tarfile.TarInfo(name)
            info.size = len(data)
            opened.addfile(info, io.BytesIO(data))
    return packed.getvalue()


def tgz_with_link(name: str, target: str, kind: bytes = tarfile.SYMTYPE) -> bytes:
    """@param kind of the entry: a link, or what has no target, as a device"""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w:gz") as opened:
        link = tarfile.TarInfo(name)
        link.type = kind
        link.linkname = target
        opened.addfile(link)
    return packed.getvalue()


PACK = {"a.zip": zip_of, "a.tgz": tgz_of}


def gz_of(members: dict[str, bytes]) -> bytes:
    (data,) = members.values()
    return gzip.compress(data, mtime=0)


PACK_OR_GZ = {**PACK, "a.obj.gz": gz_of}


def put(world: World, file: str, packed: bytes, member: str | None = "a.obj") -> None:
    """A mesh of the manifest that comes in this archive, and should be the triangle."""
    world.put(f"site/{file}", packed)
    more = {"archive_member": member} if member else {}
    mesh = downloaded("a", f"site/{file}", packed, **more)
    world.meshes = [{**mesh, "sha256": sha256(TRIANGLE)}]


def refusal(world: World, capsys: pytest.CaptureFixture[str]) -> str:
    """The line that a fetch ends with, which leaves nothing behind."""
    assert world.fetch() == 3
    assert (world.cached(), world.leftovers()) == ([], [])
    line = capsys.readouterr().err
    assert line.startswith("a: missing: ") and len(line.splitlines()) == 1
    return line.removeprefix("a: missing: ").rstrip("\n")


@pytest.mark.parametrize("file", PACK)
def test_only_the_named_member_leaves_an_archive(world: World, file: str) -> None:
    outside = ["../evil.obj", "b/../../evil.obj", f"{world.folder}/evil.obj"]
    put(world, file, PACK[file]({**dict.fromkeys(outside, b"x"), "a.obj": TRIANGLE}))
    assert world.fetch() == 0
    assert world.cached() == ["a.obj"]
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE
    assert not list(world.folder.glob("**/evil.obj"))


@pytest.mark.parametrize("file", PACK)
@pytest.mark.parametrize("member", ["../../a.obj", "/a.obj", "b/../../a.obj", "..\\a.obj"])
def test_a_named_member_that_points_outside_is_refused(
    world: World, file: str, member: str, capsys: pytest.CaptureFixture[str]
) -> None:
    put(world, file, PACK[file]({member: TRIANGLE}), member)
    assert refusal(world, capsys) == f"'{member}' points outside {file}: not unpacked"


@pytest.mark.parametrize(("file", "pack"), [("a.zip", zip_with_link), ("a.tgz", tgz_with_link)])
def test_a_link_is_refused(
    world: World,
    file: str,
    pack: Callable[[str, str], bytes],
    capsys: pytest.CaptureFixture[str],
) -> None:
    put(world, file, pack("a.obj", "/etc/passwd"))
    assert refusal(world, capsys) == f"a.obj in {file} is not a regular file: not unpacked"


@pytest.mark.parametrize(
    "kind",
    [tarfile.LNKTYPE, tarfile.CHRTYPE, tarfile.BLKTYPE, tarfile.FIFOTYPE, tarfile.DIRTYPE],
)
def test_a_device_a_pipe_a_folder_or_a_hard_link_is_refused(
    world: World, kind: bytes, capsys: pytest.CaptureFixture[str]
) -> None:
    put(world, "a.tgz", tgz_with_link("a.obj", "/etc/passwd", kind))
    assert refusal(world, capsys) == "a.obj in a.tgz is not a regular file: not unpacked"


@pytest.mark.parametrize("file", PACK_OR_GZ)
def test_what_unpacks_to_too_much_is_refused(
    world: World, file: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(archive, "MAX_BYTES", 3 << 20)
    packed = PACK_OR_GZ[file]({"a.obj": bytes(4 << 20)})
    put(world, file, packed, "a.obj" if file in PACK else None)
    assert refusal(world, capsys).endswith("unpacks to more than 3145728 bytes: not used")


@pytest.mark.parametrize("file", PACK)
def test_an_archive_without_the_member_is_named(
    world: World, file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    put(world, file, PACK[file]({"b.obj": TRIANGLE}))
    assert refusal(world, capsys) == f"{file} holds no a.obj"


def test_a_member_with_other_contents_is_not_used(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    put(world, "a.zip", zip_of({"a.obj": TRIANGLE + b"#"}))
    line = refusal(world, capsys)
    assert line.startswith("a.obj out of a.zip has sha256 ") and sha256(TRIANGLE) in line


@pytest.mark.parametrize("file", PACK_OR_GZ)
@pytest.mark.parametrize("damage", ["no archive", "cut short"])
def test_a_damaged_archive_is_one_line(
    world: World, file: str, damage: str, capsys: pytest.CaptureFixture[str]
) -> None:
    whole = PACK_OR_GZ[file]({"a.obj": TRIANGLE})
    packed = TRIANGLE if damage == "no archive" else whole[: len(whole) // 2]
    put(world, file, packed, "a.obj" if file in PACK else None)
    assert refusal(world, capsys).startswith(f"{file} cannot be unpacked: ")


def test_a_gz_file_is_unpacked(world: World) -> None:
    put(world, "a.obj.gz", gzip.compress(TRIANGLE), None)
    assert world.fetch() == 0
    assert (world.cache / "a.obj").read_bytes() == TRIANGLE


def test_a_tampered_archive_is_not_opened(
    world: World, capsys: pytest.CaptureFixture[str]
) -> None:
    put(world, "a.zip", zip_of({"a.obj": TRIANGLE}))
    tampered = zip_of({"a.obj": TRIANGLE, "b.obj": b"x"})
    path = world.put("site/a.zip", tampered)
    assert refusal(world, capsys).startswith(f"{path} has sha256 {sha256(tampered)}, the manifest")
