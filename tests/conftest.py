"""Fixtures that every test may use."""

from __future__ import annotations

import gc
import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

# Workers take all cores: threads of numpy's would wait for each other. Read when it is imported.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from adagen.build import cache_folder, find_toolchain
from adagen.garbage import ALLOCATIONS
from tests.emitted import HURRIED, Builder

# Examples take as long as the machine is busy: a test that found nothing wrong is not to fail.
settings.register_profile("without deadlines", deadline=None)
settings.load_profile("without deadlines")

ROOT = Path(__file__).resolve().parents[1]


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-golden",
        action="store_true",
        help="write generated_examples anew instead of comparing with it (make golden)",
    )


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Let an update run nothing but what writes the golden files."""
    if config.getoption("--update-golden"):
        kept = [item for item in items if item.get_closest_marker("golden")]
        config.hook.pytest_deselected(items=[item for item in items if item not in kept])
        items[:] = kept


def pytest_collection_finish() -> None:
    """Let Python not look for cycles among tests and modules, of which none ends before the run.

    Each time it did took a quarter of a second, and a sixth of the time of tests in Python. Among
    what tests make it looks as seldom as adagen has it.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(ALLOCATIONS)


@pytest.fixture(scope="session")
def shared() -> Path:
    """The folder of shared robots with true answers; tests that need it skip where it is absent."""
    folder = ROOT.parent / "shared" / "robots"
    if not folder.is_dir():
        pytest.skip("the shared robots are not beside this checkout")
    return folder


@pytest.fixture(scope="session", autouse=True)
def _builds_of_the_tool(request: pytest.FixtureRequest) -> Iterator[None]:
    """What the tool itself builds is found again by any test or worker, and not in ~/.cache.

    Little is optimised: the compiler's time counts, not the program's.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CXXFLAGS", " ".join(("-Og", *HURRIED)))
        patch.setenv("XDG_CACHE_HOME", str(request.config.cache.mkdir("adagen-home")))
        yield


@pytest.fixture(scope="session")
def builder() -> Builder:
    """Builds emitted sources; what was built before, by any test or worker, is found again.

    It is kept where the tool keeps what it builds: the program around solvers is the same.
    """
    return Builder(cache_folder(), find_toolchain())
