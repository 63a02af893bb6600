"""Where the upstream files of downloaded meshes are: at their sites, or in a mirror of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from .errors import FetchError

MIRROR_VARIABLE = "GEODESIC_DATASETS_MIRROR"

# From the `path` of an entry to its file: a Path in a folder, or an http(s) address.
Origin = Callable[[str], Path | str]


def upstream(sources: Mapping[str, Mapping[str, str]]) -> Origin:
    """The sites of the manifest's sources, the first folder of a path being a source's name."""

    def locate(path: str) -> str:
        source, _, rest = path.partition("/")
        return sources[source]["base"] + rest

    return locate


def mirror_at(place: str) -> Origin:
    """A folder, file:// address or http(s):// address below which every path lies as it is.

    Raises FetchError for any other kind of address.
    """
    parts = urlsplit(place)
    if parts.scheme in ("http", "https") and parts.netloc:
        return lambda path: f"{place.rstrip('/')}/{path}"
    if parts.scheme == "file" and parts.netloc in ("", "localhost"):
        return lambda path: Path(url2pathname(parts.path)) / path
    if "://" in place:
        raise FetchError(
            f"{MIRROR_VARIABLE} is {place}: give a folder, or an address that begins with "
            "file:///, http:// or https://"
        )
    return lambda path: Path(place) / path


def origin_from_environment(sources: Mapping[str, Mapping[str, str]]) -> Origin:
    """The mirror that $GEODESIC_DATASETS_MIRROR names; without one, the upstream sites."""
    place = os.environ.get(MIRROR_VARIABLE)
    return mirror_at(place) if place else upstream(sources)
