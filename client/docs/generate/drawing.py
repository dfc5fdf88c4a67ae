"""Draws a closed surface of triangles, coloured and labelled by face, seen from one or more sides, without a
display."""
import numpy as np
from PIL import Image, ImageDraw, ImageFont
from matplotlib import get_data_path
from scipy.ndimage import distance_transform_edt

WIDTH, HEIGHT, FINER = 480, 340, 2  # px; pixels are drawn FINER times as fine
ABOVE, BELOW = 28, 74  # px: room for the caption and the axes
BOTH = ((-55, 28, "from above"), (125, -28, "from below, behind"))  # degrees: azimuth, elevation
COLOURS = ((252, 141, 98), (141, 160, 203), (102, 194, 165), (231, 138, 195), (166, 216, 84),
           (255, 217, 47), (229, 196, 148), (128, 205, 222))
FONT = ImageFont.truetype(get_data_path() + "/fonts/ttf/DejaVuSans.ttf", 13 * FINER)
SMALL = ImageFont.truetype(get_data_path() + "/fonts/ttf/DejaVuSans.ttf", 11 * FINER)
ONE = ((-62, 24, ""),)
GREY, BLACK, NOTHING = (110, 110, 110), (20, 20, 20), -1


def view_axes(azimuth, elevation):
    """Rows: right, up and towards the viewer, in world coordinates."""
    a, e = np.radians([azimuth, elevation])
    back = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0])
    return np.array([right, np.cross(back, right), back])


def rasterise(corners, shape):
    """Index of the foremost triangle at each pixel, NOTHING where there is none, and how far from its edges
    that is. `corners` (m, 3, 3): px right, px down, depth towards the viewer."""
    depth = np.full(shape, -np.inf)
    which = np.full(shape, NOTHING)
    edge = np.full(shape, np.inf)
    for index, triangle in enumerate(corners):
        (x0, y0), (x1, y1) = (np.floor(triangle[:, :2].min(0)).astype(int),
                              np.ceil(triangle[:, :2].max(0)).astype(int) + 1)
        x, y = np.meshgrid(np.arange(x0, x1), np.arange(y0, y1))
        p = triangle[:, :2]
        area = np.cross(p[1] - p[0], p[2] - p[0])
        if abs(area) < 1e-9:
            continue
        shares, away = [], []
        for k in range(3):
            a, b = p[(k + 1) % 3], p[(k + 2) % 3]
            twice = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
            shares.append(twice / area)
            away.append(abs(twice) / np.linalg.norm(b - a))
        z = sum(share * triangle[k, 2] for k, share in enumerate(shares))
        window = np.s_[y0:y1, x0:x1]
        front = (np.minimum.reduce(shares) >= -1e-9) & (z > depth[window])
        depth[window][front] = z[front]
        which[window][front] = index
        edge[window][front] = np.minimum.reduce(away)[front]
    return which, edge


def render(points, triangles, owner, axes, scale, width):
    """A picture of `width` pixels, and the face at each."""
    shape = (HEIGHT * FINER, width)
    seen = points @ axes.T
    middle = (seen.min(0) + seen.max(0)) / 2
    flat = (seen - middle) * [scale, -scale, scale] + [shape[1] / 2, (HEIGHT + ABOVE - BELOW) * FINER / 2, 0]
    corners = flat[triangles]
    which, edge = rasterise(corners, shape)
    normals = np.cross(*(seen[triangles[:, k]] - seen[triangles[:, 0]] for k in (1, 2)))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    light = 0.72 + 0.28 * np.clip(normals @ np.array([-0.4, 0.5, 0.77]), 0, 1)
    colours = np.array(COLOURS)[owner % len(COLOURS)] * light[:, None]
    image = np.full((*shape, 3), 255.0)
    inside = which != NOTHING
    image[inside] = colours[which[inside]]
    image[inside & (edge < 0.5 * FINER)] *= 0.85
    face = np.where(inside, owner[which], NOTHING)
    for axis in (0, 1):  # rims of faces
        image[(np.diff(face, axis=axis, append=face.take([-1], axis=axis)) != 0)] = 60
    return Image.fromarray(image.astype(np.uint8)), face


def places(anchor):
    """Where a label's middle may be, and how far that is from its anchor."""
    for distance in range(0, 320, 8):
        count = max(1, distance // 3)
        for k in range(count):
            angle = 2 * np.pi * k / count
            yield anchor + distance * np.array([np.cos(angle), 0.8 * np.sin(angle)]), distance


def label(draw, text, anchor, face, taken):
    """Box of a label near its anchor, over no other and over little of other faces than its own. A line leads
    to the anchor where it is not on it. `face`: that at each pixel."""
    width, height = draw.textbbox((0, 0), text, font=FONT)[2:]
    half = np.array([width / 2 + 8, height / 2 + 5])
    own, best = face[anchor[1], anchor[0]], (np.inf, None)
    for middle, distance in places(np.array(anchor, float)):
        x0, y0, x1, y1 = box = np.concatenate([middle - half, middle + half]).astype(int)
        if x0 < 4 or y0 < (ABOVE - 4) * FINER or x1 > face.shape[1] - 4 or y1 > face.shape[0] - 4 \
                or any(x0 < b[2] and b[0] < x1 and y0 < b[3] and b[1] < y1 for b in taken):
            continue
        under = face[y0:y1, x0:x1]
        cost = distance + 250 * ((under != own) & (under != NOTHING)).mean()
        if cost < best[0]:
            best = (cost, box)
    box = best[1]
    if box is None:
        raise ValueError(f"no room for the label {text}")
    if not (box[0] <= anchor[0] <= box[2] and box[1] <= anchor[1] <= box[3]):
        draw.line([((box[0] + box[2]) / 2, (box[1] + box[3]) / 2), tuple(anchor)], fill=BLACK, width=FINER)
        draw.ellipse([anchor[0] - 5, anchor[1] - 5, anchor[0] + 5, anchor[1] + 5], fill=BLACK)
    taken.append(box)
    return box, text


def draw_axes(draw, axes, corner):
    for k, name in enumerate("xyz"):
        tip = corner + np.array([axes[0, k], -axes[1, k]]) * 22 * FINER
        draw.line([tuple(corner), tuple(tip)], fill=GREY, width=FINER)
        end = corner + (tip - corner) * (1 + 9 * FINER / max(np.linalg.norm(tip - corner), 1))
        draw.text(tuple(end), name, font=SMALL, fill=GREY, anchor="mm")


def draw_view(picture, face, axes, caption, anchors):
    """Labels a picture. `anchors`: place in it by text."""
    draw = ImageDraw.Draw(picture)
    corner = np.array([34 * FINER, (HEIGHT - 36) * FINER])
    draw_axes(draw, axes, corner)
    draw.text((picture.width / 2, 12 * FINER), caption, font=SMALL, fill=GREY, anchor="mm")
    taken = [np.concatenate([corner - 34 * FINER, corner + 34 * FINER])]
    for box, text in [label(draw, text, anchor, face, taken) for text, anchor in anchors.items()]:
        draw.rounded_rectangle(list(box), radius=6, fill="white", outline=BLACK)
        draw.text(((box[0] + box[2]) / 2, (box[1] + box[3]) / 2), text, font=FONT, fill=BLACK, anchor="mm")


def draw_faces(points, triangles, owner, names, views=BOTH):
    """The picture. `points` (n, 3); `triangles` (m, 3) into them, turning outward; `owner` (m): index into
    `names`. A face is labelled in the first view that shows it well. ValueError where BOTH do not."""
    axes = [view_axes(*view[:2]) for view in views]
    width = WIDTH * FINER // len(views)
    room = np.array([width - 36 * FINER, (HEIGHT - ABOVE - BELOW) * FINER])
    scale = min((room / np.ptp(points @ one.T, axis=0)[:2]).min() for one in axes)
    parts = [render(points, triangles, owner, one, scale, width) for one in axes]
    anchors = [{} for _ in parts]
    for index, name in enumerate(names):
        depths = [distance_transform_edt(face == index) for _, face in parts]
        largest = max(depth.max() for depth in depths)
        if largest < 3 and views is not BOTH:
            continue
        if largest < 2:
            raise ValueError(f"face {name} cannot be seen")
        at = next(k for k, depth in enumerate(depths) if depth.max() >= 0.6 * largest)
        y, x = np.unravel_index(depths[at].argmax(), depths[at].shape)
        anchors[at][name] = (x, y)
    canvas = Image.new("RGB", (WIDTH * FINER, HEIGHT * FINER), "white")
    for k, (image, face) in enumerate(parts):
        draw_view(image, face, axes[k], views[k][2], anchors[k])
        canvas.paste(image, (k * width, 0))
    return canvas.resize((WIDTH, HEIGHT), Image.LANCZOS)
