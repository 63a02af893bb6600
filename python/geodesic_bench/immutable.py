"""Objects that do not change, so that copies of them need no memory."""

from __future__ import annotations

from typing import TypeVar

_Object = TypeVar("_Object", bound="Immutable")


class Immutable:
    """An object whose copies, also deep ones, are itself."""

    def __copy__(self: _Object) -> _Object:
        return self

    def __deepcopy__(self: _Object, copied: object) -> _Object:
        return self
