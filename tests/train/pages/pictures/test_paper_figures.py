"""The papers' figures are drawn from our own runs, and each is a picture of the site."""

import numpy as np
import pytest

from soccer_env.train.pages.pictures import paper_figures
from soccer_env.train.pages.pictures.paper_figures import FIGURES, until_decided
from soccer_env.train.pages.pictures.settings import FOLDER


def test_each_figure_is_a_picture_beside_the_number_of_the_papers() -> None:
    assert {file.name for file in FOLDER.glob("paper-*.png")} == {f"paper-{name}.png" for name in FIGURES}
    assert all(figure.paper.startswith(("Heinemann et al. 2006, figures", "Sacks 2001")) for figure in FIGURES.values())


def test_a_figure_is_drawn_the_same_each_time() -> None:
    drawn = FIGURES["paths"].draw()
    assert drawn.startswith(b"\x89PNG") and drawn == FIGURES["paths"].draw()


def test_a_shot_is_drawn_until_it_is_saved_or_in() -> None:
    trail = np.zeros((4, 5))
    trail[2] = [3.0, 2.0, 1.0, 1.5, 0.0]
    assert until_decided(trail)[2].tolist() == [3.0, 2.0, 1.0]
    trail[2] = [3.0, 2.0, 1.0, 0.5, 0.0]
    assert until_decided(trail).shape == (4, 4)


def test_one_command_draws_one_figure(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    written: dict[str, bytes] = {}
    monkeypatch.setattr(paper_figures, "write_atomically", lambda path, content: written.update({path.name: content}))
    monkeypatch.setitem(FIGURES, "paths", FIGURES["paths"]._replace(draw=lambda: b"drawn"))
    assert paper_figures.main(["paths"]) == 0 and written == {"paper-paths.png": b"drawn"}
    assert paper_figures.main(["path"]) == 2 and "unknown figure 'path'" in capsys.readouterr().err
