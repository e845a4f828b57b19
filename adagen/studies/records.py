"""What studies have measured, kept as plain data in one JSON file each."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from adagen.atomic_files import write_whole
from adagen.errors import InputError

Record = TypeVar("Record")


def write_record(record: Any, path: Path, *, allow_nan: bool = True) -> None:
    """Write a dataclass as a JSON file, whole or not at all.

    Args:
        record: the dataclass.
        path: the file.
        allow_nan: whether numbers may be infinite or none.

    Raises:
        EnvironmentFault: writing failed.
    """
    data = dataclasses.asdict(record)
    write_whole(path, json.dumps(data, indent=1, allow_nan=allow_nan) + "\n")


def record_in(path: Path, kind: str, made: Callable[[dict[str, Any]], Record]) -> Record:
    """Return the record in a file.

    Args:
        path: the file.
        kind: of record, in words.
        made: the record of the file's data.

    Raises:
        InputError: it cannot be read, or is no record of this kind.
    """
    try:
        return made(json.loads(path.read_text(encoding="utf-8")))
    except OSError as error:
        raise InputError(f"cannot read it: {error.strerror}", str(path)) from None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError(f"not {kind}: {error}", str(path)) from None
