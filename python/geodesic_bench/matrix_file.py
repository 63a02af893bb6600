"""A matrix in a .npy file that is written a block of rows after the other, and continued later.

Until it is complete, it is FILE.unfinished: behind the numbers, that file has the sum of its problem and
how many rows are finished. A killed process loses the block that it was writing."""

from __future__ import annotations

import errno
import fcntl
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

open_memmap: Any = np.lib.format.open_memmap  # has no types


class MatrixFile:
    """The file while it is written. One process at a time may use it. Its disk space is reserved at once; the
    memory of the process need not hold it."""

    _map: Any
    rows: int
    """The first rows, which are finished."""

    def __init__(self, file: str | os.PathLike[str], shape: tuple[int, int], dtype: str, problem: str) -> None:
        """Begins the file, or continues an unfinished one.

        @param problem the sum of all that the numbers depend on
        @raises ValueError for another extension, and for an unfinished file that is in use or of another problem
        @raises OSError when there is no room for the file"""
        self._file = Path(file)
        if self._file.suffix != ".npy":
            raise ValueError(f"{self._file}: a matrix is written as .npy")
        self._unfinished = self._file.with_name(f"{self._file.name}.unfinished")
        self._problem = problem.encode()
        is_new = not self._unfinished.exists()
        self._stream = open(self._unfinished, "x+b" if is_new else "r+b")
        try:
            self._lock()
            if is_new:
                self._map = open_memmap(self._unfinished, "w+", dtype, shape)
                self._end = self._map.offset + self._map.nbytes
                os.posix_fallocate(self._stream.fileno(), 0, self._end + len(self._record(0)))
                self._keep(0)
            else:
                self.rows = self._rows()
                self._map = open_memmap(self._unfinished, "r+")
                self._end = self._map.offset + self._map.nbytes
        except BaseException as error:
            self._stream.close()
            if is_new:
                self._unfinished.unlink()
            if isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EFBIG):
                size = f"{shape[0]} rows and {shape[1]} columns in {dtype}"
                raise OSError(error.errno, f"no room for a matrix of {size}", str(self._file)) from None
            raise

    def part(self, begin: int, end: int) -> NDArray[Any]:
        """Returns some rows, to be written."""
        rows: NDArray[Any] = self._map[begin:end]
        return rows

    def keep(self, rows: int) -> None:
        """Records that the first rows are finished."""
        self._map.flush()
        self._keep(rows)

    def finish(self) -> NDArray[Any]:
        """Gives the complete file its name. @return the matrix, as a read-only map of the file"""
        del self._map
        os.ftruncate(self._stream.fileno(), self._end)
        os.fsync(self._stream.fileno())
        self._unfinished.replace(self._file)
        self._stream.close()
        matrix: NDArray[Any] = open_memmap(self._file, "r")
        return matrix

    def leave(self) -> None:
        """Closes the file for a later continuation; removes it when no row is finished."""
        if self.rows == 0:
            self._unfinished.unlink()
        self._stream.close()

    def _lock(self) -> None:
        try:
            fcntl.flock(self._stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ValueError(f"{self._unfinished} is in use by another process") from None

    def _record(self, rows: int) -> bytes:
        return self._problem + b"%020d" % rows

    def _keep(self, rows: int) -> None:
        os.pwrite(self._stream.fileno(), self._record(rows), self._end)
        self.rows = rows

    def _rows(self) -> int:
        size = len(self._record(0))
        record = os.pread(self._stream.fileno(), size, max(0, self._unfinished.stat().st_size - size))
        rows = record.removeprefix(self._problem)
        if len(record) != size or rows == record or not rows.isdigit():
            raise ValueError(
                f"{self._unfinished} has the rows of another matrix: remove it, or give another name"
            )
        return int(rows)
