# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a recipe file, drawn without a window."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from ..base.errors import Fault, RecipeError
from ..base.progress import Progress
from ..checking import check_with_meshes, prepare
from ..files.atomic import FileSet
from ..pictures import Scene, draw, scene_of_answer, scene_of_recipe
from ..recipe.reading import named_in, read_json
from .session import Session


def show(
    recipe_path: str | Path,
    picture: str | Path,
    pose: str | None = None,
    *,
    after: bool = False,
    view: tuple[float, float, float] | None = None,
    files: FileSet | None = None,
    progress: Progress | None = None,
) -> None:
    """Draw a recipe to a PNG file: regions in the colours of their roles, and motions as arrows.

    Parameters
    ----------
    recipe_path, picture : str or path
        The recipe and the PNG file.
    pose : str, optional
        Name of one of the recipe's poses.
    after : bool
        Draw the parts in that pose, coloured by displacement.
    view : tuple of float, optional
        Direction (3,) from the centre to the eye.
    files : FileSet, optional
        A new file set.
    progress : callable, optional
        progress(fraction, task) returns whether to continue.

    Raises
    ------
    RecipeError, FileError, KernelError, PictureError
    """
    path = Path(recipe_path)
    if Path(picture).suffix.lower() != ".png":
        raise RecipeError(
            [
                Fault(
                    "-o",
                    f"pictures are PNG files, and {picture} is not one",
                    "use a name that ends in .png",
                )
            ]
        )
    recipe = read_json(path)
    with named_in(path):
        parts = prepare(recipe, path.parent, progress)
        if pose is not None and pose not in recipe.get("poses", {}):
            known = ", ".join(recipe.get("poses", {})) or "none"
            raise RecipeError([Fault("poses", f'there is no pose "{pose}"', f"it has {known}")])
        if after:
            session = Session(recipe, parts.meshes, progress, found=parts.found)
            wanted = recipe["poses"][pose] if pose else None
            scene = scene_of_answer(session.deform(wanted), _title(path, pose))
        else:
            model = check_with_meshes(parts.resolved.recipe, parts.meshes, parts.found)
            scene = scene_of_recipe(model, parts.meshes, _title(path, pose), pose or "")
    with files or FileSet("show") as out:
        out.reads += [path, *(file for source in parts.sources for file in source.file.files_read)]
        draw([(_seen_from(scene, view), Path(picture))], out)
        out.commit()


def _title(path: Path, pose: str | None) -> str:
    return f"{path.name}, pose {pose}" if pose else path.name


def _seen_from(scene: Scene, view: tuple[float, float, float] | None) -> Scene:
    return scene if view is None else replace(scene, view=view)
