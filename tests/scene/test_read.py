"""Scene files: what is understood, and one line with file, line and reason for every slip."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.errors import InputError
from adagen.scene import Scene, read_scene
from adagen.scene.types import Base, JointScene, PointMass
from adagen.tomlfile import Source

FULL = """\
# everything that a scene can say
gravity = [0, 0, -1.62]
base = { kind = "planar", axis = [0, 0, 1] }
mimic = true
lock_all_but = ["a", "b"]
keep = ["foot"]
accelerations = [
    "a",
    # why b
    "b",
]
forces = ["hand"]
damping = "urdf"
friction = 0.5
friction_speed = 0.02

[lock]
c = 0.25
ball = [0, 0, 0, 1]

[joints.a]
damping = 0.1
stiffness = 4
rest = -0.2
rotor_inertia = 1e-3

[joints."b c"]
prescribed = true

[[point_masses]]
link = "hand"
mass = 2
position = [0, 0, 0.1]

[[point_masses]]
link = "foot"
mass = 0.5
"""


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "s.toml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def test_everything_is_understood(tmp_path: Path) -> None:
    scene = read_scene(written(tmp_path, FULL))
    assert scene.gravity == (0.0, 0.0, -1.62)
    assert scene.base == Base("planar", (0.0, 0.0, 1.0))
    assert scene.mimic is True
    assert scene.lock_all_but == ("a", "b") == scene.accelerations
    assert (scene.keep, scene.forces) == (("foot",), ("hand",))
    assert (scene.damping, scene.friction, scene.friction_speed) == ("urdf", 0.5, 0.02)
    assert scene.lock == {"c": (0.25,), "ball": (0.0, 0.0, 0.0, 1.0)}
    assert scene.joints == {
        "a": JointScene({"damping": 0.1, "stiffness": 4.0, "rest": -0.2, "rotor_inertia": 1e-3}),
        "b c": JointScene({}, prescribed=True),
    }
    assert scene.point_masses == (
        PointMass("hand", 2.0, (0.0, 0.0, 0.1)),
        PointMass("foot", 0.5, (0.0, 0.0, 0.0)),
    )
    assert scene.floating
    assert scene.from_urdf == {"damping"}


def test_an_empty_scene_asks_for_nothing(tmp_path: Path) -> None:
    assert read_scene(written(tmp_path, "")) == Scene(Source(str(tmp_path / "s.toml"), ""))


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("gravity",), 2),
        (("base", "axis"), 3),
        (("accelerations",), 7),
        (("accelerations", 1), 7),
        (("forces", 0), 12),
        (("lock", "c"), 18),
        (("lock",), 17),
        (("joints", "a"), 21),
        (("joints", "a", "rest"), 24),
        (("joints", "b c", "prescribed"), 28),
        (("point_masses", 0, "mass"), 32),
        (("point_masses", 1), 35),
        (("nowhere",), None),
    ],
)
def test_lines_are_found(path: tuple[str | int, ...], line: int | None) -> None:
    assert Source("s.toml", FULL).line(*path) == line


@given(
    st.lists(st.sampled_from(["", "# x", "k{} = [\n 1,\n 2\n]", "k{} = 3", "[t{}]"]), max_size=30)
)
def test_every_key_of_a_file_has_the_line_that_starts_it(pieces: list[str]) -> None:
    lines = [piece.format(k) for k, piece in enumerate(pieces)]
    text = "\n".join(lines)
    at = 1
    table: tuple[str, ...] = ()
    expected: dict[tuple[str, ...], int] = {}
    for line in lines:
        if line.startswith("["):
            table = (line[1:-1],)
            expected[table] = at
        elif line.startswith("k"):
            expected[(*table, line.split(" ")[0])] = at
        at += line.count("\n") + 1
    tomllib.loads(text)
    assert {path: Source("s", text).line(*path) for path in expected} == expected


BAD = {
    # name: (text, line, words that the message must have)
    "not toml": ("gravity = [0, 0\n", 2, "not TOML"),
    "unquoted": ("a = b\n", 1, "not TOML: invalid value"),
    "twice": ("mimic = true\nmimic = true\n", 2, "not TOML"),
    "unknown key": ("\ngravty = [0, 0, 0]\n", 2, "unknown key 'gravty'; did you mean 'gravity'?"),
    "unlike any key": ("zzz = 1\n", 1, "known: accelerations, at_rest, base"),
    "loop of no kind": ('\n[[loops]]\nname = "a"\n', 2, "this loop has no kind"),
    "loop of no such kind": (
        '[[loops]]\nkind = "revolut"\nlink1 = "a"\nlink2 = "b"\n',
        2,
        "unknown kind of loop 'revolut'; did you mean 'revolute'?",
    ),
    "loop without axis": (
        '[[loops]]\nkind = "revolute"\nlink1 = "a"\nlink2 = "b"\n',
        1,
        "this revolute loop has no axis",
    ),
    "loop with one axis of two": (
        '[[loops]]\nname = "u"\nkind = "universal"\nlink1 = "a"\nlink2 = "b"\naxis = [0, 0, 1]\n',
        1,
        "this universal loop 'u' has no axis2",
    ),
    "loop with an axis too many": (
        '[[loops]]\nkind = "point"\nlink1 = "a"\nlink2 = "b"\naxis = [0, 0, 1]\n',
        5,
        "a point loop has no axis: leave it out",
    ),
    "loop about no axis": (
        '[[loops]]\nkind = "planar"\nlink1 = "a"\nlink2 = "b"\naxis = [0, 0, 0]\n',
        5,
        "the axis has length zero",
    ),
    "loop origin": (
        '[[loops]]\nkind = "weld"\nlink1 = "a"\nlink2 = "b"\norigin1 = { xys = [0, 0, 0] }\n',
        5,
        "unknown key of an origin 'xys'; did you mean 'xyz'?",
    ),
    "two loops of a name": (
        2 * '[[loops]]\nname = "x"\nkind = "weld"\nlink1 = "a"\nlink2 = "b"\n',
        6,
        "two loops are named 'x': rename one",
    ),
    "coupling of one": ('[[couplings]]\njoint = "a"\n', 1, "this coupling has no other"),
    "coupling with itself": (
        '[[couplings]]\njoint = "a"\nother = "a"\nratio = 2\n',
        3,
        "joint 'a' is coupled to itself",
    ),
    "coupling said twice": (
        '[[couplings]]\njoint = "a"\nterms = { a = 1, b = 2 }\n',
        2,
        "this coupling has terms: leave joint out",
    ),
    "coupling of nothing": ("[[couplings]]\nterms = {}\n", 2, "this coupling has no terms"),
    "coupling by zeros": (
        "[[couplings]]\nterms = { a = 0, b = 0.0 }\n",
        2,
        "all terms of this coupling are zero",
    ),
    "two numbers": ("gravity = [0, 0]\n", 1, "gravity needs 3 numbers in a list"),
    "gravity text": ('gravity = ["a", 0, 0]\n', 1, "'a' is not a number"),
    "gravity true": ("gravity = [true, 0, 0]\n", 1, "True is not a number"),
    "gravity nan": ("gravity = [nan, 0, 0]\n", 1, "not a finite number"),
    "gravity inf": ("gravity = [inf, 0, 0]\n", 1, "not a finite number"),
    "gravity huge": ("gravity = [1e300, 0, 0]\n", 1, "not a finite number"),
    "base number": ("base = 3\n", 1, "'base' is not a table"),
    "base unknown": ('base = "floting"\n', 1, "unknown base 'floting'; did you mean 'floating'?"),
    "base strange": ('base = "x"\n', 1, "known: fixed, floating"),
    "base key": ('base = {kind="planar", axs=[0,0,1]}\n', 1, "'axs'; did you mean 'axis'?"),
    "base no kind": ("[base]\naxis = [0,0,1]\n", 1, "base needs a kind"),
    "base no axis": ('base = "prismatic"\n', 1, "a prismatic base needs an axis"),
    "base zero axis": ('base = {kind="revolute", axis=[0,0,0]}\n', 1, "length zero"),
    "base idle axis": ('[base]\nkind = "floating"\naxis = [0,0,1]\n', 3, "has no axis"),
    "mimic": ("mimic = 1\n", 1, "neither true nor false"),
    "lock value": ('[lock]\na = "up"\n', 2, "lock.a: 'up' is not a number"),
    "lock list": ("lock = []\n", 1, "'lock' is not a table"),
    "names": ('keep = "a"\n', 1, "keep needs a list of names"),
    "no name": ("keep = [1]\n", 1, "1 is not a name"),
    "name twice": ('forces = ["a", "a"]\n', 1, "names 'a' twice"),
    "damping": ("damping = -1\n", 1, "-1 is negative"),
    "damping word": ('damping = "sdf"\n', 1, "neither a number nor 'urdf'"),
    "speed": ("friction_speed = 0\n", 1, "must be more than 0"),
    "joint key": ("[joints.a]\ndampin = 1\n", 2, "unknown key of joint 'a' 'dampin'; did you mean"),
    "joint table": ("joints.a = 1\n", 1, "'a' is not a table"),
    "joint negative": ("[joints.a]\nrotor_inertia = -1\n", 2, "is negative"),
    "joint rest": ("[joints.a]\nrest = 1\n", 2, "a rest but no stiffness"),
    "joint speed": ("[joints.a]\nfriction_speed = 0\n", 2, "must be more than 0"),
    "prescribed": ("[joints.a]\nprescribed = 1\n", 2, "neither true nor false"),
    "mass table": ("[point_masses]\nmass = 1\n", 1, "write [[point_masses]]"),
    "mass key": ('[[point_masses]]\nlink="a"\nmas = 1\n', 3, "'mas'; did you mean 'mass'?"),
    "mass without link": ("[[point_masses]]\nmass = 1\n", 1, "has no link"),
    "mass without mass": ('[[point_masses]]\nlink = "a"\n', 1, "has no mass"),
    "mass zero": ('[[point_masses]]\nlink = "a"\nmass = 0\n', 3, "has no mass: leave it out"),
    "mass place": ('[[point_masses]]\nlink="a"\nmass=1\nposition=1\n', 4, "needs 3 numbers"),
}


@pytest.mark.parametrize("name", BAD)
def test_a_bad_scene_is_refused_by_line(name: str, tmp_path: Path) -> None:
    text, line, words = BAD[name]
    path = written(tmp_path, text)
    with pytest.raises(InputError) as refusal:
        read_scene(path)
    assert str(refusal.value).startswith(f"{path}:{line}: error: ")
    assert words in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_files_that_are_none_are_refused(tmp_path: Path) -> None:
    cases: list[tuple[Path, str]] = [
        (tmp_path, "is not a regular file"),
        (tmp_path / "absent.toml", "cannot read it"),
        (written(tmp_path, b"a = '\xff'"), "not UTF-8"),
    ]
    for path, words in cases:
        with pytest.raises(InputError, match=words):
            read_scene(path)
    with pytest.raises(InputError, match="larger than 1 MiB"):
        read_scene(written(tmp_path, "#" * (2**20 + 1)))
    with pytest.raises(InputError, match="nested too deeply"):
        read_scene(written(tmp_path, "keep = " + "[" * 100000))


def test_lines_with_windows_ends_count_once(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=":3: error: "):
        read_scene(written(tmp_path, "mimic = true\r\n\r\nkep = 1\r\n"))
