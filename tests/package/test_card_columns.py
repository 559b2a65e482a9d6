# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of every card that decks are read by, against the field tables of public manuals.

The tables below were written from the manuals, not from the reader. Every card is written with a
number of its own in every field, in every layout of its format; a reader that looks one field too
far finds another node.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from sheetmorph.decks import read_deck
from sheetmorph.decks.deck import Deck

REAL = Path(__file__).resolve().parents[3] / "shared" / "data" / "09-decks" / "radioss"

# Fields as the quick reference guides print them, line by line: G.. is a node, - is blank, a word
# in quotes stands for itself, R.. is a real number, all others are whole numbers.
NASTRAN = """
CTRIA3 EID PID G1 G2 G3
CTRIAR EID PID G1 G2 G3
CQUAD4 EID PID G1 G2 G3 G4
CQUADR EID PID G1 G2 G3 G4
CSHEAR EID PID G1 G2 G3 G4
CTRIA6 EID PID G1 G2 G3 G4 G5 G6
CQUAD8 EID PID G1 G2 G3 G4 G5 G6 / G7 G8
CQUAD EID PID G1 G2 G3 G4 G5 G6 / G7 G8 G9
CPLSTN3 EID PID G1 G2 G3
CPLSTN4 EID PID G1 G2 G3 G4
CPLSTN6 EID PID G1 G2 G3 G4 G5 G6
CPLSTN8 EID PID G1 G2 G3 G4 G5 G6 / G7 G8
CTETRA EID PID G1 G2 G3 G4 G5 G6 / G7 G8 G9 G10
CPYRAM EID PID G1 G2 G3 G4 G5 G6 / G7 G8 G9 G10 G11 G12 G13
CPENTA EID PID G1 G2 G3 G4 G5 G6 / G7 G8 G9 G10 G11 G12 G13 G14 / G15
CHEXA EID PID G1 G2 G3 G4 G5 G6 / G7 G8 G9 G10 G11 G12 G13 G14 / G15 G16 G17 G18 G19 G20
CBAR EID PID G1 G2 R1 R2 R3
CBEAM EID PID G1 G2 R1 R2 R3
CBEND EID PID G1 G2 R1 R2 R3 N
CROD EID PID G1 G2
CTUBE EID PID G1 G2
CVISC EID PID G1 G2
CBUSH EID PID G1 G2 R1 R2 R3 CID
CBUSH1D EID PID G1 G2 CID
CGAP EID PID G1 G2 R1 R2 R3 CID
CBEAM3 EID PID G1 G2 G3 R1 R2 R3
CONROD EID G1 G2 MID R1 R2
PLOTEL EID G1 G2
CELAS1 EID PID G1 C1 G2 C2
CELAS2 EID R1 G1 C1 G2 C2 R2 R3
CELAS3 EID PID G1 G2
CELAS4 EID R1 G1 G2
CDAMP1 EID PID G1 C1 G2 C2
CDAMP2 EID R1 G1 C1 G2 C2
CDAMP3 EID PID G1 G2
CDAMP4 EID R1 G1 G2
CMASS1 EID PID G1 C1 G2 C2
CMASS2 EID R1 G1 C1 G2 C2
CMASS3 EID PID G1 G2
CONM1 EID G1 CID R1 R2
CONM2 EID G1 CID R1 R2 R3 R4
RBAR EID G1 G2 CNA CNB CMA CMB
RROD EID G1 G2 CMA CMB
RTRPLT EID G1 G2 G3 CNA CNB CNC
RBE2 EID G1 CM G2 G3 G4 G5 G6 / G7 G8
RBE3 EID - G1 REFC R1 C1 G2 G3 / G4 R2 C2 G5 G6 R3 C3 G7
RBE1 EID G1 CN1 G2 CN2 G3 CN3 - / "UM" G4 CM1 G5 CM2
MPC SID G1 C1 R1 G2 C2 R2 - / - G3 C3 R3 G4 C4 R4
CWELD EID PWID - "ALIGN" G1 G2
CWELD EID PWID G1 "PARTPAT" - - - MCID / PIDA PIDB
CWELD EID PWID G1 "ELEMID" G2 G3 - MCID / SHIDA SHIDB
CWELD EID PWID G1 "GRIDID" G2 G3 "QT" - / G4 G5 G6 G7 - - - - / G8 G9 G10
CFAST EID PID "PROP" IDA IDB G1 G2 G3
CSEAM EID PID R1 "PSHELL" IDAS IDBS IDAE IDBE / G1 G2
"""

# Fields of LS-DYNA's manual in their order, cards apart by /; n.. is a node, r.. is a real number.
# The width is that of the first column below: ids of elements and nodes, or all others.
DYNA = """
label ELEMENT_SHELL eid pid n1 n2 n3 n4 n5 n6 n7 n8
label ELEMENT_TSHELL eid pid n1 n2 n3 n4 n5 n6 n7 n8
label ELEMENT_SOLID eid pid / n1 n2 n3 n4 n5 n6 n7 n8 n9 n10
label ELEMENT_BEAM eid pid n1 n2 n3
label ELEMENT_DISCRETE eid pid n1 n2 vid
label ELEMENT_SEATBELT eid pid n1 n2 sbrid
label ELEMENT_PLOTEL eid n1 n2
other CONSTRAINED_SPOTWELD n1 n2 r1 r2 r3 r4 r5 r6
other CONSTRAINED_SPOTWELD_ID wid / n1 n2 r1 r2
other CONSTRAINED_SPOTWELD_FILTERED_FORCE n1 n2 r1 r2 / nf r3
other CONSTRAINED_SPOTWELD_FILTERED_FORCE_ID wid / n1 n2 r1 r2 / nf r3
other CONSTRAINED_RIVET n1 n2 r1
other CONSTRAINED_RIVET_ID rid / n1 n2 r1
other CONSTRAINED_JOINT_REVOLUTE n1 n2 n3 n4 n5 n6 r1 r2
other DEFINE_COORDINATE_NODES cid n1 n2 n3 flag
"""

# Columns of the Radioss starter manual, from 1, as (data line from 1, first, last) of every node.
RADIOSS = {
    "SHELL": [(1, 11, 20), (1, 21, 30), (1, 31, 40), (1, 41, 50)],
    "SH3N": [(1, 11, 20), (1, 21, 30), (1, 31, 40)],
    "QUAD": [(1, 11, 20), (1, 21, 30), (1, 31, 40), (1, 41, 50)],
    "TRIA": [(1, 11, 20), (1, 21, 30), (1, 31, 40)],
    "BRICK": [(1, 11 + 10 * k, 20 + 10 * k) for k in range(8)],
    "TETRA4": [(1, 11, 20), (1, 21, 30), (1, 31, 40), (1, 41, 50)],
    "PENTA6": [(1, 11 + 10 * k, 20 + 10 * k) for k in range(6)],
    "SPRING": [(1, 11, 20), (1, 21, 30), (1, 31, 40)],
    "BEAM": [(1, 11, 20), (1, 21, 30), (1, 31, 40)],
    "TRUSS": [(1, 11, 20), (1, 21, 30)],
    "TETRA10": [(2, 1 + 10 * k, 10 + 10 * k) for k in range(10)],
    "SHEL16": [(line, 1 + 10 * k, 10 + 10 * k) for line in (2, 3) for k in range(8)],
    "BRIC20": [
        (line, 1 + 10 * k, 10 + 10 * k) for line, n in ((2, 8), (3, 8), (4, 4)) for k in range(n)
    ],
}


def nodes_of(deck: Deck, name: str) -> list[int]:
    """The nodes of the one element of a card."""
    rows = [row for block in deck.elements if block.name == name for row in block.nodes.tolist()]
    assert len(rows) == 1, (name, rows)
    return [node for node in rows[0] if node]


def read(text: str, suffix: str) -> Deck:
    data = text.encode("latin-1")
    return read_deck(Path(f"deck{suffix}"), lambda _: data)


def nastran_card(name: str, lines: list[list[str]], layout: str) -> str:
    """A card in small or large fields, or in fields between commas."""
    if layout == "free":
        return "\n".join(",".join([name if k == 0 else "", *line]) for k, line in enumerate(lines))
    if layout == "small":
        return "\n".join(
            f"{name if k == 0 else '':8}" + "".join(f"{text:>8}" for text in line)
            for k, line in enumerate(lines)
        )
    fields = [text for line in lines for text in line + [""] * (8 - len(line))]
    rows = [fields[k : k + 4] for k in range(0, len(fields), 4)]
    while len(rows) > 1 and not any(rows[-1]):
        rows.pop()
    return "\n".join(
        f"{name + '*' if k == 0 else '*':8}" + "".join(f"{text:>16}" for text in row)
        for k, row in enumerate(rows)
    )


@pytest.mark.parametrize("layout", ["small", "large", "free"])
@pytest.mark.parametrize("row", [line for line in NASTRAN.splitlines() if line])
def test_fields_of_nastran(row: str, layout: str):
    name, *rest = row.split()
    values = {"-": ""}
    lines = [[]]  # type: list[list[str]]
    for k, field in enumerate(rest):
        if field == "/":
            lines[-1] += [""] * (8 - len(lines[-1]))
            lines.append([])
            continue
        is_node = re.fullmatch(r"G\d+", field)
        number = 101 + int(field[1:]) if is_node else 11 + k
        shown = field.strip('"') if field[0] == '"' else values.get(field, str(number))
        lines[-1].append(f"{k + 1}.5" if re.fullmatch(r"R\d+", field) else shown)
    grids = "".join(f"GRID,{101 + k},,{k}.,0.,0.\n" for k in range(1, 25))
    deck = read(f"BEGIN BULK\n{grids}{nastran_card(name, lines, layout)}\nENDDATA\n", ".bdf")
    wanted = [101 + int(field[1:]) for field in rest if re.fullmatch(r"G\d+", field)]
    assert nodes_of(deck, name) == wanted


@pytest.mark.parametrize("layout", ["small", "large", "free"])
def test_fields_of_nastran_nodes_shells_and_systems(layout: str):
    cards = [
        ("GRID", [["7", "5", "1.25", "2.5", "3.75", "6", "123", ""]]),
        ("GRID", [["8", "", "1.", "0.", "0."]]),
        ("GRID", [["9", "", "0.", "1.", "0."]]),
        ("GRID", [["10", "", "1.", "1.", "0."]]),
        ("GRID", [["11", "", "0.", "0.", "1."]]),
        ("CORD2R", [["5", "", "10.", "20.", "30.", "10.", "20.", "31."], ["11.", "20.", "30."]]),
        ("CORD1R", [["12", "8", "9", "10", "13", "9", "10", "11"]]),
        ("PSHELL", [["3", "4", "1.75", "99", "", "98"]]),
        ("MAT1", [["4", "70000.", "", ".33", "2.7-9"]]),
        ("CQUAD4", [["1", "3", "8", "9", "10", "11", "30.", ".5"]]),
    ]
    body = "\n".join(nastran_card(name, lines, layout) for name, lines in cards)
    deck = read(f"BEGIN BULK\n{body}\nENDDATA\n", ".bdf")
    assert deck.points[deck.find(np.array([7]))[0]] == pytest.approx([11.25, 22.5, 33.75])
    assert deck.raw.thickness == {3: 1.75} and deck.raw.materials.of_property == {3: "4"}
    found = deck.raw.materials
    assert (found.young["4"], found.poisson["4"], found.density["4"]) == (70000.0, 0.33, 2.7e-9)
    assert deck.frames[12].nodes == (8, 9, 10) and deck.frames[13].nodes == (9, 10, 11)


WIDTHS = {"": (8, 10, 16), "i10=y": (10, 10, 16), "long=y": (20, 20, 20)}


def dyna_nodes(width: tuple[int, int, int]) -> str:
    rows = (
        f"{100 + k:{width[0]}d}{k:{width[2]}.1f}{0:{width[2]}}{0:{width[2]}}" for k in range(1, 25)
    )
    return "*NODE\n" + "\n".join(rows) + "\n"


@pytest.mark.parametrize("options", list(WIDTHS))
@pytest.mark.parametrize("row", [line for line in DYNA.splitlines() if line])
@pytest.mark.parametrize("count", [1, 2])
def test_fields_of_dyna(row: str, options: str, count: int):
    kind, name, *rest = row.split()
    width = WIDTHS[options][0 if kind == "label" else 1]
    is_once = name.startswith("CONSTRAINED_JOINT")
    cards = ""
    for repeat in range(1 if is_once else count):
        for k, field in enumerate(rest):
            shown = f"{100 + int(field[1:])}" if re.fullmatch(r"n\d+", field) else f"{11 + k}"
            shown = f"{k}.5" if re.fullmatch(r"r\d+", field) else shown
            cards += "\n" if field == "/" else f"{shown:>{width}}"
        cards += "\n"
    text = f"*KEYWORD {options}\n{dyna_nodes(WIDTHS[options])}*{name}\n{cards}*END\n"
    deck = read(text, ".k")
    wanted = [100 + int(field[1:]) for field in rest if re.fullmatch(r"n\d+", field)]
    found = [row for block in deck.elements for row in block.nodes.tolist()]
    assert found == [wanted] * (1 if is_once else count)


@pytest.mark.parametrize("options", list(WIDTHS))
def test_fields_of_dyna_sets_parts_and_sections(options: str):
    wide = WIDTHS[options][1]

    def card(*values: object) -> str:
        return "".join(f"{value:>{wide}}" for value in values) + "\n"

    text = f"*KEYWORD {options}\n{dyna_nodes(WIDTHS[options])}*SET_NODE_LIST\n{card(31, 0, 0)}"
    text += card(*range(101, 109)) + card(109)
    text += "*SET_NODE_COLUMN\n" + card(32) + card(111, 1.5) + card(112, 2.5)
    text += "*CONSTRAINED_NODAL_RIGID_BODY\n" + card(41, 42, 31, 110, 0)
    text += card(43, 0, 32, 113) + "*CONSTRAINED_EXTRA_NODES_SET\n" + card(44, 32)
    text += "*CONSTRAINED_GENERALIZED_WELD_SPOT\n" + card(32, 45) + "*PART\na part\n"
    text += card(51, 52, 53) + "another\n" + card(54, 55, 56)
    # Eight integration points with their angles, and a second section behind them.
    text += "*SECTION_SHELL\n" + card(52, 2, 1.0, 9, 1, 0, 1, 1) + card(1.25, 1.3, 1.3, 1.3)
    text += card(*range(8)) + card(45.0) + card(55, 2) + card(2.5)
    text += "*SECTION_SHELL_TITLE\none\n" + card(57, 2) + card(3.5) + "two\n" + card(58, 2)
    text += card(4.5) + "*MAT_ELASTIC\n" + card(53, 7.85e-9, 210000.0, 0.3) + "*END\n"
    deck = read(text, ".k")
    rigid = [row for b in deck.elements if b.kind == "rigid" for row in b.nodes.tolist()]
    assert rigid == [[110, *range(101, 110)], [113, 111, 112], [111, 112]]
    welds = [row for b in deck.elements if b.kind == "weld" for row in b.nodes.tolist()]
    assert welds == [[111, 112]]
    assert deck.raw.thickness == {51: 1.25, 54: 2.5} and deck.raw.names[51] == "a part"
    assert deck.raw.materials.young == {"53": 210000.0} and deck.raw.materials.poisson["53"] == 0.3


def put(lines: dict[int, str], place: tuple[int, int, int], value: object) -> None:
    """A value, as far right as it goes, into the columns of a data line."""
    line, first, last = place
    shown = lines.get(line, "").ljust(last)
    lines[line] = shown[: first - 1] + f"{value:>{last - first + 1}}" + shown[last:]


def radioss_nodes() -> str:
    text = "#RADIOSS STARTER\n/BEGIN\nrun\n      2022         0\n/NODE\n"
    for k in range(1, 31):
        lines: dict[int, str] = {}
        for place, value in (((1, 1, 10), 100 + k), ((1, 11, 30), k), ((1, 31, 50), 2 * k),
                             ((1, 51, 70), 3 * k)):  # fmt: skip
            put(lines, place, value)
        text += lines[1] + "\n"
    return text


@pytest.mark.parametrize("name", list(RADIOSS))
def test_columns_of_radioss(name: str):
    lines: dict[int, str] = {}
    put(lines, (1, 1, 10), 77)
    for k, place in enumerate(RADIOSS[name]):
        put(lines, place, 101 + k)
    body = "\n".join(lines[k] for k in sorted(lines))
    deck = read(f"{radioss_nodes()}/{name}/5\n{body}\n/END\n", ".rad")
    assert deck.points[deck.find(np.array([107]))[0]].tolist() == [7, 14, 21]
    assert nodes_of(deck, f"/{name}") == [101 + k for k in range(len(RADIOSS[name]))]
    (block,) = deck.elements
    assert block.ids.tolist() == [77] and block.properties.tolist() == [5]


@pytest.mark.parametrize("unit", ["", "/9"])
def test_columns_of_radioss_bodies_parts_and_properties(unit: str):
    body: dict[int, str] = {}
    for k, (first, last, value) in enumerate(
        [(1, 10, 130), (11, 20, 2), (21, 30, 3), (31, 40, 5), (41, 60, 6), (61, 70, 4),
         (71, 80, 7), (81, 90, 8), (91, 100, 9)]
    ):  # fmt: skip
        put(body, (1, first, last), value)
    strand: dict[int, str] = {}
    put(strand, (1, 1, 10), 88)
    put(strand, (1, 11, 20), 4)
    shell: dict[int, str] = {}
    for line, first, last, value in [(1, 1, 10, 24), (1, 41, 60, 1), (2, 1, 20, 0.1), (3, 1, 10, 5),
                                     (3, 21, 40, 1.35), (3, 41, 60, 0.8)]:  # fmt: skip
        put(shell, (line, first, last), value)
    part: dict[int, str] = {}
    for first, last, value in [(1, 10, 21), (11, 20, 22), (21, 30, 23)]:
        put(part, (1, first, last), value)
    text = f"{radioss_nodes()}/RBODY/1{unit}\nbody\n{body[1]}\n/GRNOD/NODE/4{unit}\ngroup\n"
    text += "".join(f"{101 + k:10d}" for k in range(10)) + "\n       111       112\n"
    text += f"/XELEM/5\n{strand[1]}\n/PART/6{unit}\na part\n{part[1]}\n/PROP/TYPE1/21{unit}\np\n"
    text += "\n".join(shell[k] for k in (1, 2, 3)) + "\n/END\n"
    deck = read(text, ".rad")
    assert nodes_of(deck, "/RBODY") == [130, *range(101, 113)]
    assert nodes_of(deck, "/XELEM") == list(range(101, 113))
    assert deck.raw.thickness == {6: 1.35} and deck.raw.names[6] == "a part"


@pytest.mark.parametrize(
    "group, wanted",
    [
        ("/GRNOD/NODENS/4\ng\n       103       101\n", [103, 101]),
        ("/GRNOD/GENE/4\ng\n       103       105\n", [103, 104, 105]),
        ("/GRNOD/PART/4\ng\n         5\n", [101, 102, 103, 104]),
        ("/GRNOD/GRNOD/4\ng\n         8        -9\n/GRNOD/NODE/8\ng\n       101       102\n"
         "/GRNOD/NODE/9\ng\n       102\n", [101]),
    ],
)  # fmt: skip
def test_groups_of_radioss_of_all_kinds_make_rigid_bodies(group: str, wanted: list[int]):
    shell = "/SHELL/5\n" + "".join(f"{n:10d}" for n in (1, 101, 102, 103, 104)) + "\n"
    body = "/RBODY/1\nb\n" + f"{130:10d}" + " " * 50 + f"{4:10d}\n"
    deck = read(f"{radioss_nodes()}{shell}{body}{group}/END\n", ".rad")
    assert nodes_of(deck, "/RBODY") == [130, *wanted]


def test_a_group_that_is_not_read_is_named():
    body = "/RBODY/1\nb\n" + f"{130:10d}" + " " * 50 + f"{4:10d}\n/GRNOD/BOX/4\ng\n         9\n"
    deck = read(f"{radioss_nodes()}{body}/END\n", ".rad")
    assert "/RBODY 1 is not checked: the nodes of its group 4 are not known" in deck.notes[0]


@pytest.mark.parametrize(
    "card, wanted",
    [
        ("*ELEMENT, TYPE=S3\n1, 2, 3, 4\n", [2, 3, 4]),
        ("*ELEMENT, TYPE=S4R\n1, 2, 3, 4, 5\n", [2, 3, 4, 5]),
        ("*ELEMENT, TYPE=S8R\n1, 2, 3, 4, 5, 6, 7, 8, 9\n", list(range(2, 10))),
        ("*ELEMENT, TYPE=STRI65\n1, 2, 3, 4, 5, 6, 7\n", list(range(2, 8))),
        ("*ELEMENT, TYPE=C3D20R\n1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16,\n"
         "17, 18, 19, 20, 21\n", list(range(2, 22))),
        ("*ELEMENT, TYPE=B31\n1, 2, 3\n", [2, 3]),
        ("*ELEMENT, TYPE=B22H\n1, 2, 3, 4\n", [2, 3, 4]),
        ("*ELEMENT, TYPE=B32R\n1, 2, 3, 4\n", [2, 3, 4]),
        ("*ELEMENT, TYPE=B33\n1, 2, 3\n", [2, 3]),
        ("*ELEMENT, TYPE=T3D2\n1, 2, 3\n", [2, 3]),
        ("*MPC\nBEAM, 2, 3\n", [2, 3]),
        ("*KINEMATIC COUPLING, REF NODE=2\n3, 1, 3\n4, 1, 3\n", [2, 3, 4]),
        ("*EQUATION\n2\n2, 1, 1., 3, 1, -1.\n", [2, 3]),
        ("*EQUATION\n5\n2, 1, 1., 3, 1, -1., 4, 1, 5., 6, 2, 1.\n7, 1, 2.\n", [2, 3, 4, 6, 7]),
        ("*NSET, NSET=S\n4, 5\n*RIGID BODY, REF NODE=2, TIE NSET=S\n", [2, 4, 5]),
    ],
)  # fmt: skip
def test_fields_of_abaqus(card: str, wanted: list[int]):
    nodes = "".join(f"{k}, {k}., {2 * k}., {3 * k}.\n" for k in range(1, 31))
    deck = read(f"*NODE\n{nodes}{card}", ".inp")
    assert deck.points[6].tolist() == [7, 14, 21]
    (block,) = deck.elements
    assert [node for node in block.nodes[0].tolist() if node] == wanted


def test_radioss_columns_are_those_that_comments_of_real_decks_name():
    """Pre-processors write the name of every field above its columns."""
    if not REAL.is_dir():
        pytest.skip("the decks of ../shared/data are not on this machine")
    from sheetmorph.decks.radioss.table import field

    seen = 0
    for path in sorted(REAL.glob("*.rad")):
        lines = path.read_bytes().decode("latin-1").splitlines()
        for k, line in enumerate(lines[:-3]):
            if not line.startswith("/RBODY/"):
                continue
            head = next((one for one in lines[k + 1 : k + 4] if "nod_id" in one.lower()), "")
            if head:
                place = field("RBODY", "group")
                assert head.lower().index("nod_id") + len("nod_id") == place.begin + place.width
                seen += 1
    assert seen > 3
