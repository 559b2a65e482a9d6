# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study as a Snakefile, for all clusters that Snakemake supports."""

from __future__ import annotations

import json

from .scripts import Call, write_script

FILE = "Snakefile"

_TEXT = """# Computes a study of SheetMorph: snakemake -s {place} --cores N
BLOCKS = {blocks}
OUT = {out}


rule all:
    input:
        OUT + "/summary.csv",


rule block:
    output:
        touch(OUT + "/.blocks/{{first}}-{{last}}"),
    shell:
        {block}


rule summary:
    input:
        [OUT + "/.blocks/" + block for block in BLOCKS],
    output:
        OUT + "/summary.csv",
    shell:
        {summary}
"""


def write_snakefile(call: Call, jobs: int) -> list[str]:
    """Write the Snakefile and return the lines to print."""
    place = call.out.resolve() / FILE
    blocks = [f"{first}-{last}" for first, last in call.blocks(jobs)]
    text = _TEXT.format(
        place=place,
        blocks=json.dumps(blocks),
        out=json.dumps(str(call.out.resolve())),
        block=json.dumps(_escaped(call.command("--runs")) + " {wildcards.first}-{wildcards.last}"),
        summary=json.dumps(_escaped(call.command())),
    )
    write_script(place, text)
    return [f"{place}: written; compute the study with: snakemake -s {place} --cores {jobs}"]


def _escaped(command: str) -> str:
    """Double the braces, which Snakemake interprets."""
    return command.replace("{", "{{").replace("}", "}}")
