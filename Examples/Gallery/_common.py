# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the gallery's scripts share: the data, the look of a picture, and where it goes."""

import argparse
from pathlib import Path

import numpy as np
import pyvista as pv
from matplotlib.colors import LinearSegmentedColormap
from PIL import Image

parser = argparse.ArgumentParser()
parser.add_argument("--output", type=Path, default=Path("demo-output"), metavar="FOLDER")
OUTPUT = parser.parse_args().output
DATA = Path(__file__).resolve().parents[2] / "Data"

# Low to high: forest, meadow, rock, ash, snow.
HEIGHTS = LinearSegmentedColormap.from_list(
    "heights", ["#34624a", "#78925c", "#a88e68", "#b0a096", "#e4e5ee"]
)
pv.global_theme.show_scalar_bar = False

INK = "#28282d"
BLUE = "#123d80"
ORANGE = "#db4714"


def read(name):
    return pv.read(DATA / name)


def plotter(panels, size):
    """Panels side by side, off screen, white, lit from the left and above."""
    scene = pv.Plotter(
        shape=(1, panels), off_screen=True, window_size=size, border=False, lighting="none"
    )
    for position, intensity in (((-0.7, 0.9, 1), 0.8), ((1, 0, 0.8), 0.4), ((0, -0.5, 1), 0.3)):
        scene.add_light(pv.Light(position=position, light_type="camera light", intensity=intensity))
    scene.set_background("white")
    scene.enable_anti_aliasing("ssaa")
    return scene


def look(scene, towards, up=(0, 0, 1), text=""):
    """A parallel view of all that the panel shows, from a direction, and a caption below."""
    # PyVista's own view is of a ball around everything, and leaves much of the panel white.
    scene.view_vector(towards, up)
    scene.enable_parallel_projection()
    right = np.cross(up, towards)
    axes = np.array([axis / np.linalg.norm(axis) for axis in (right, np.cross(towards, right))])
    seen = np.vstack([actor.mapper.dataset.points @ axes.T for actor in scene.actors.values()])
    low, high = seen.min(axis=0), seen.max(axis=0)

    caption = 0.1 if text else 0
    left, _, end, _ = scene.renderer.viewport
    width, height = scene.window_size
    fits = (high - low) / ((end - left) * width / height, 1 - caption)
    half = 0.5 * fits.max() / 0.94
    shift = ((low + high) / 2 - (0, caption * half) - axes @ scene.camera.focal_point) @ axes
    scene.camera.focal_point += shift
    scene.camera.position += shift
    scene.camera.parallel_scale = half
    scene.reset_camera_clipping_range()
    scene.add_text(text, position="lower_edge", font_size=9, color=INK)


def write(scene, name):
    """The picture, into the folder that --output names."""
    OUTPUT.mkdir(parents=True, exist_ok=True)
    image = Image.fromarray(scene.screenshot(return_img=True))
    # 256 colours, dithered, look the same here, in less than half of the bytes.
    chosen = image.quantize(256, kmeans=1)
    image = image.quantize(palette=chosen, dither=Image.Dither.FLOYDSTEINBERG)
    # A colour stands for several that are near it. That of the background is to be white.
    first = 3 * image.getpixel((0, 0))
    palette = image.getpalette()
    image.putpalette([*palette[:first], 255, 255, 255, *palette[first + 3 :]])
    image.save(OUTPUT / name)
    print(f"wrote {OUTPUT / name}")
