"""Extraction of a mesh from good and bad archives."""

from __future__ import annotations

import gzip
import io
import stat
import tarfile
import zipfile
from collections.abc import Callable
from functools import partial

import pytest
from fetch_world import TRIANGLE, Missing, World, downloaded, sha256, tgz_of
from fetching import archive


def zip_of(members: dict[str, bytes] | dict[zipfile.ZipInfo, bytes]) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as opened:
        for name, data in members.items():
            opened.writestr(name, data)
    return packed.getvalue()


def zip_with_link() -> bytes:
    link = zipfile.ZipInfo("a.obj")
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    return zip_of({link: b"/etc/passwd"})


def gz_of(members: dict[str, bytes]) -> bytes:
    (data,) = members.values()
    return gzip.compress(data, mtime=0)


Pack = Callable[[dict[str, bytes]], bytes]
PACK: dict[str, Pack] = {"a.zip": zip_of, "a.tgz": tgz_of}
PACK_OR_GZ: dict[str, Pack] = {**PACK, "a.obj.gz": gz_of}


def put(world: World, file: str, packed: bytes, member: str = "a.obj") -> None:
    """Makes the mesh in this archive the only mesh of the manifest. It must be the triangle."""
    world.put(f"site/{file}", packed)
    more = {} if file.endswith(".gz") else {"archive_member": member}
    mesh = downloaded("a", f"site/{file}", packed, **more)
    world.meshes = [{**mesh, "sha256": sha256(TRIANGLE)}]


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
    world: World, file: str, member: str, missing: Missing
) -> None:
    put(world, file, PACK[file]({member: TRIANGLE}), member)
    assert missing() == f"'{member}' points outside {file}: not unpacked"


NO_FILES = [
    tarfile.SYMTYPE,
    tarfile.LNKTYPE,
    tarfile.CHRTYPE,
    tarfile.BLKTYPE,
    tarfile.FIFOTYPE,
    tarfile.DIRTYPE,
]


@pytest.mark.parametrize(
    ("file", "pack"),
    [
        ("a.zip", zip_with_link),
        *(("a.tgz", partial(tgz_of, {"a.obj": b""}, kind)) for kind in NO_FILES),
    ],
)
def test_a_link_a_device_a_pipe_and_a_folder_are_refused(
    world: World, file: str, pack: Callable[[], bytes], missing: Missing
) -> None:
    put(world, file, pack())
    assert missing() == f"a.obj in {file} is not a regular file: not unpacked"


@pytest.mark.parametrize("file", PACK_OR_GZ)
def test_what_unpacks_to_too_much_is_refused(
    world: World, file: str, monkeypatch: pytest.MonkeyPatch, missing: Missing
) -> None:
    monkeypatch.setattr(archive, "MAX_BYTES", 3 << 20)
    put(world, file, PACK_OR_GZ[file]({"a.obj": bytes(4 << 20)}))
    assert missing().endswith("unpacks to more than 3145728 bytes: not used")


@pytest.mark.parametrize("file", PACK)
def test_an_archive_without_the_member_is_named(
    world: World, file: str, missing: Missing
) -> None:
    put(world, file, PACK[file]({"b.obj": TRIANGLE}))
    assert missing() == f"{file} holds no a.obj"


def test_a_member_with_other_contents_is_not_used(world: World, missing: Missing) -> None:
    put(world, "a.zip", zip_of({"a.obj": TRIANGLE + b"#"}))
    line = missing()
    assert line.startswith("a.obj out of a.zip has sha256 ") and sha256(TRIANGLE) in line


@pytest.mark.parametrize("file", PACK_OR_GZ)
@pytest.mark.parametrize("damage", ["no archive", "cut short"])
def test_a_damaged_archive_is_one_line(
    world: World, file: str, damage: str, missing: Missing
) -> None:
    whole = PACK_OR_GZ[file]({"a.obj": TRIANGLE})
    put(world, file, TRIANGLE if damage == "no archive" else whole[: len(whole) // 2])
    assert missing().startswith(f"{file} cannot be unpacked: ")


def test_a_tampered_archive_is_not_opened(world: World, missing: Missing) -> None:
    put(world, "a.zip", zip_of({"a.obj": TRIANGLE}))
    tampered = zip_of({"a.obj": TRIANGLE, "b.obj": b"x"})
    path = world.put("site/a.zip", tampered)
    assert missing().startswith(f"{path} has sha256 {sha256(tampered)}, the manifest")
