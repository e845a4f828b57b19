"""Every malformed or hostile input gets one line with file, line, element and reason."""

from __future__ import annotations

import gzip
import re
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from adagen.errors import InputError
from adagen.urdf import Reading, read_robot
from adagen.urdf.description import TYPES
from tests.urdf.texts import BODY, INERTIA, MASS, ORIGIN, Y, joint, link, pair, robot

Read = Callable[..., Reading]
Refusal = Callable[..., str]

GOOD = pair()
TWO = robot(link("a"), link("b"), link("c"), joint("j1", "a", "b"), joint("j2", "b", "c"))


def body(origin: str = ORIGIN, mass: str = MASS, inertia: str = INERTIA) -> str:
    return f"<inertial>{origin}{mass}{inertia}</inertial>"


def with_iyy(text: str) -> str:
    return pair(body(inertia=INERTIA.replace('iyy="0.01"', text)))


CASES = {
    # name: (text, line, words that the message must have)
    "empty": ("", None, "empty"),
    "blank": (" \n\n ", None, "empty"),
    "no xml": ("hello", 1, "not XML"),
    "truncated": (GOOD[: GOOD.index('<axis xyz="0 1')], 5, "not well formed"),
    "truncated between": (TWO[: TWO.index('<joint name="j2"')], 7, "not well formed"),
    "truncated in attribute": (GOOD[: GOOD.index("revolute") + 3], 5, "not well formed"),
    "attribute twice": (GOOD.replace("<mass v", '<mass value="2" v'), 3, "not well formed"),
    "two roots of the document": (GOOD + GOOD[22:], 7, "not well formed"),
    "undefined entity": (GOOD.replace('"j1"', '"&foo;"'), 5, "not well formed"),
    "doctype": ("<!-- x -->\n<!DOCTYPE robot []>\n" + GOOD[22:], 2, "DTD"),
    "external entity": (
        '<!DOCTYPE robot [<!ENTITY x SYSTEM "file:///etc/passwd">]>\n' + GOOD[22:],
        1,
        "DTD",
    ),
    "html": ("<!DOCTYPE html><html><body>Not Found</body></html>", 1, "<html> is not <robot>"),
    "html without doctype": ("<html><body/></html>", 1, "<html> is not <robot>"),
    "sdf": ('<sdf version="1.7"><model name="m"/></sdf>', 1, "SDF"),
    "mjcf": ('<mujoco model="m"/>', 1, "MJCF"),
    "other root": ("<urdf/>", 1, "<urdf> is not <robot>"),
    "git-lfs": ("version https://git-lfs.github.com/spec/v1\noid x\n", 1, "git lfs pull"),
    "gzip": (gzip.compress(GOOD.encode()), 1, "gzip"),
    "binary": (bytes(range(256)) * 8, 1, "binary"),
    "nul": (GOOD.replace("j1", "j\0"), 1, "binary"),
    "bad utf-8": (GOOD.encode().replace(b"j1", b"j\xff"), 5, "invalid UTF-8"),
    "cut utf-16": (GOOD.encode("utf-16")[:-1], None, "invalid UTF-16"),
    "odd encoding": (
        GOOD.replace('version="1.0"', 'version="1.0" encoding="EBCDIC-US"'),
        1,
        "ebcdic-us",
    ),
    "namespace": (
        GOOD.replace("<robot", '<d:robot xmlns:d="urn:d"').replace("</robot", "</d:robot"),
        2,
        'remove the prefix "d:"',
    ),
    "namespace inside": (
        GOOD.replace('<link name="b"', '<link xmlns="http://x" name="b"'),
        4,
        "namespace",
    ),
    "xacro": (
        GOOD.replace("</robot>", '<x:if xmlns:x="http://ros.org/wiki/xacro" value="1"/></robot>'),
        6,
        "xacro",
    ),
    "xacro undeclared": (GOOD.replace("</robot>", '<xacro:include f="x"/></robot>'), 6, "xacro"),
    "xacro number": (GOOD.replace('value="1"', 'value="${m}"'), 3, "xacro"),
    "letter case of an element": (GOOD.replace("link name", "Link name"), None, "not well formed"),
    "Axis": (GOOD.replace(Y, '<Axis xyz="0 1 0"/>'), 5, "write <axis>"),
    "no links": ('<robot name="r"/>', 1, "no <link>"),
    "link without name": (robot(link("a").replace(' name="a"', "")), 3, 'name="..."'),
    "empty name": (robot(link("")), 3, "empty"),
    "link twice": (robot(link("a"), link("a")), 4, 'link name "a" is used twice, first in line 3'),
    "joint twice": (TWO.replace("j2", "j1"), 7, 'joint name "j1" is used twice, first in line 6'),
    "no type": (GOOD.replace(' type="revolute"', ""), 5, 'joint "j1" has no type'),
    "unknown type": (pair(kind="hinge"), 5, 'unknown type "hinge": known types are revolute'),
    "type case": (pair(kind="Revolute"), 5, 'unknown type "Revolute"'),
    "no parent": (GOOD.replace('<parent link="a"/>', ""), 5, "no <parent>"),
    "no child": (GOOD.replace('<child link="b"/>', ""), 5, "no <child>"),
    "parent without link": (GOOD.replace('<parent link="a"/>', "<parent/>"), 5, "is missing"),
    "two children": (GOOD.replace("<child", '<child link="a"/><child'), 5, "2 <child>"),
    "undeclared parent": (GOOD.replace('<parent link="a"/>', '<parent link="w"/>'), 5, '"w"'),
    "undeclared child": (GOOD.replace('<child link="b"/>', '<child link="w"/>'), 5, '"w"'),
    "joint to itself": (GOOD.replace('<child link="b"/>', '<child link="a"/>'), 5, "to itself"),
    "two parents": (
        robot(*(link(x) for x in "abc"), joint("j1", "a", "b"), joint("j2", "a", "c"),
              joint("j3", "b", "c")),
        8,
        'link "c" has two parent joints, "j2" and "j3": loop "j3" cannot close: one of its links '
        "spans 0.2 m, all others together 0 m",
    ),
    "stray link": (robot(link("a"), link("b"), link("stray"), joint("j1", "a", "b")), 5, "stray"),
    "loop off the root": (
        robot(*(link(x) for x in "abcd"), joint("j1", "a", "b"), joint("j2", "c", "d"),
              joint("j3", "d", "c")),
        9,
        '"c", "d" form a loop',
    ),
    "no mass": (pair(body(mass="")), 4, 'link "b": <inertial> without <mass>'),
    "no inertia": (pair(body(inertia="")), 4, 'link "b": <inertial> without <inertia>'),
    "mass without value": (pair(body(mass="<mass/>")), 4, "value"),
    "mass as text": (pair(body(mass="<mass>1</mass>")), 4, "value"),
    "two inertials": (pair(BODY + BODY), 4, 'link "b" has 2 <inertial>'),
    "two masses": (pair(body(mass=MASS + MASS)), 4, "2 <mass>"),
    "partial inertia": (
        pair(body(inertia='<inertia ixx="0.01" ixy="0" ixz="0" iyz="0"/>')),
        4,
        "iyy, izz of <inertia> missing",
    ),
    "negative mass": (pair(body(mass='<mass value="-1"/>')), 4, "negative"),
    "tiny mass": (pair(body(mass='<mass value="1e-50"/>')), 4, "too small"),
    "inf": (with_iyy('iyy="inf"'), 4, 'link "b": iyy of <inertia> "inf" is not finite'),
    "nan": (pair(j='<axis xyz="nan 0 1"/>'), 5, 'joint "j1": xyz of <axis> "nan" is not finite'),
    "overflow": (pair(body(mass='<mass value="1e400"/>')), 4, "not representable"),
    "gigantic": (pair(body(mass='<mass value="1e300"/>')), 4, "too large"),
    "underflow": (pair(body(mass='<mass value="1e-400"/>')), 4, "too small for a double"),
    "underscore": (pair(body(mass='<mass value="1_000"/>')), 4, '"1_000" is not a number'),
    "full width": (pair(body(mass='<mass value="\uff11"/>')), 4, "is not a number"),
    "hexadecimal": (pair(body(mass='<mass value="0x1p3"/>')), 4, "is not a number"),
    "comma": (pair(body(mass='<mass value="0,5"/>')), 4, "is not a number"),
    "no-break space": (pair(body(mass='<mass value="1\u00a0"/>')), 4, "is not a number"),
    "rpy of four": (pair(body('<origin rpy="0 0 0 0"/>')), 4, "rpy of <origin> has 4 numbers"),
    "xyz of two": (pair(body('<origin xyz="0 0"/>')), 4, "xyz of <origin> has 2 numbers"),
    "quaternion": (pair(body('<origin quat_xyzw="0 0 0 1"/>')), 4, '"quat_xyzw"'),
    "misspelt xyz": (pair(j='<axis xzy="0 0 1"/>'), 5, '"xzy"'),
    "axis without xyz": (pair(j="<axis/>"), 5, "xyz"),
    "zero axis": (pair(j='<axis xyz="0 0 0"/>'), 5, "length zero"),
    "negative inertia": (with_iyy('iyy="-0.01"'), 4, 'link "b": inertia is not positive definite'),
    "mimics itself": (pair(j=Y + '<mimic joint="j1"/>'), 5, 'joint "j1" mimics itself'),
    "massless leaf": (
        robot(link("a"), link("b"), link("t", ""), joint("j1", "a", "b"), joint("j2", "b", "t")),
        7,
        'joint "j2" moves no mass',
    ),
    "one link": (robot(link("a")), 2, "nothing to solve"),
    "one massless link": (robot(link("a", "")), 2, "nothing to solve"),
    "all fixed": (pair(kind="fixed"), 2, "every joint is fixed"),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_refuses_with_one_line(case: str, refusal: Refusal) -> None:
    text, line, words = CASES[case]
    said = refusal(text)
    place = "robot.urdf:" if line is None else f"robot.urdf:{line}:"
    assert said.startswith(place), said
    assert " error: " in said
    assert words in said


@pytest.mark.parametrize("text", [GOOD, TWO])
def test_the_robots_that_the_cases_spoil_are_good(text: str, read: Read) -> None:
    assert read(text).model.joints


def test_unknown_type_lists_the_known_ones(refusal: Refusal) -> None:
    said = refusal(pair(kind="hinge"))
    assert all(kind in said for kind in TYPES)


def test_names_are_printed_harmlessly(refusal: Refusal) -> None:
    said = refusal(robot(link("a&#10;\x7fb"), link("a&#10;\x7fb")))
    assert "a\\n\\x7fb" in said


def test_long_names_are_shortened(refusal: Refusal) -> None:
    name = "n" * 10**6
    said = refusal(robot(link(name), link(name)))
    assert len(said) < 1100
    assert said.endswith("rename one")


def test_lines_far_down(refusal: Refusal) -> None:
    assert refusal("<robot>" + "\n" * 99_999 + "<link/></robot>").startswith("robot.urdf:100000:")


class TestFiles:
    def test_missing(self, tmp_path: Path) -> None:
        self._refused(tmp_path / "does_not_exist.urdf", "no such file")

    def test_directory(self, tmp_path: Path) -> None:
        self._refused(tmp_path, "is a directory")

    def test_dangling_link(self, tmp_path: Path) -> None:
        (tmp_path / "x.urdf").symlink_to("nowhere.urdf")
        self._refused(tmp_path / "x.urdf", "symbolic link to a file that does not exist")

    def test_link_to_itself(self, tmp_path: Path) -> None:
        (tmp_path / "x.urdf").symlink_to("x.urdf")
        self._refused(tmp_path / "x.urdf", "symbolic links form a loop")

    def test_fifo_does_not_block(self, tmp_path: Path) -> None:
        import os

        os.mkfifo(tmp_path / "x.urdf")
        self._refused(tmp_path / "x.urdf", "not a regular file")

    def test_device(self) -> None:
        self._refused(Path("/dev/zero"), "not a regular file")

    def test_unreadable(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        # Root may read everything, so that the refusal is staged.
        import os

        path = tmp_path / "x.urdf"
        path.write_text(GOOD)

        def deny(*_: object) -> int:
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr(os, "open", deny)
        self._refused(path, "permission denied")

    def test_nul_in_the_name(self) -> None:
        self._refused(Path("a\0b"), "cannot be read")

    def test_name_too_long(self, tmp_path: Path) -> None:
        self._refused(tmp_path / ("x" * 5000), "cannot be read")

    def test_file_in_place_of_a_folder(self, tmp_path: Path) -> None:
        (tmp_path / "x").write_text("")
        self._refused(tmp_path / "x" / "y.urdf", "cannot be read")

    def test_too_large(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr("adagen.urdf.source.LARGEST_FILE", 2**20)
        path = tmp_path / "x.urdf"
        path.write_bytes(b" " * (2**20 + 1))
        self._refused(path, "larger than 1 MiB")

    @staticmethod
    def _refused(path: Path, words: str) -> None:
        with pytest.raises(InputError, match=re.escape(words)) as caught:
            read_robot(path)
        assert "\n" not in str(caught.value)


def test_too_many_links(refusal: Refusal, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("adagen.urdf.description.LIMIT", 1)
    assert "more than 1 links" in refusal(GOOD)


def test_bomb_is_refused_at_once(refusal: Refusal) -> None:
    entities = '<!ENTITY a "aaaaaaaaaa">' + "".join(
        f'<!ENTITY {b} "{f"&{a};" * 20}">' for a, b in zip("abcdefghi", "bcdefghij", strict=True)
    )
    text = f'<!DOCTYPE robot [{entities}]>\n<robot name="b"><link name="&j;"/></robot>'
    start = time.monotonic()
    assert "DTD" in refusal(text)
    assert time.monotonic() - start < 10.0  # expanded it has 5e12 characters


def test_many_attributes_take_no_quadratic_time(read: Read) -> None:
    many = "".join(f' a{i}="x"' for i in range(100_000))
    start = time.monotonic()
    assert len(read(GOOD.replace("<robot", "<robot" + many)).model.joints) == 1
    assert time.monotonic() - start < 10.0


def test_deep_nesting_is_refused(refusal: Refusal) -> None:
    deep = "<g>" * 100_000 + "</g>" * 100_000
    assert "not well formed" in refusal(GOOD.replace("</robot>", deep + "</robot>"))
