"""Draws a closed surface of triangles, coloured and labelled by face, seen from two sides: no display needed."""
import numpy as np
from PIL import Image, ImageDraw, ImageFont
from matplotlib import get_data_path
from scipy.ndimage import distance_transform_edt

WIDTH, HEIGHT, FINER = 480, 340, 2  # px; pixels are drawn FINER times as fine
ABOVE, BELOW = 28, 74  # px: room for the caption and the axes
VIEWS = ((-55, 28, "from above"), (125, -28, "from below, behind"))  # degrees: azimuth, elevation
COLOURS = ((252, 141, 98), (141, 160, 203), (102, 194, 165), (231, 138, 195), (166, 216, 84),
           (255, 217, 47), (229, 196, 148), (128, 205, 222))
FONT = ImageFont.truetype(get_data_path() + "/fonts/ttf/DejaVuSans.ttf", 13 * FINER)
SMALL = ImageFont.truetype(get_data_path() + "/fonts/ttf/DejaVuSans.ttf", 11 * FINER)
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


def render(points, triangles, owner, axes, scale):
    """Half a picture, and the face at each pixel."""
    shape = (HEIGHT * FINER, WIDTH * FINER // 2)
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


def places(anchor, size):
    """Where a label may stand, the nearest to its anchor first: middles."""
    for distance in range(0, 320, 8):
        count = max(1, distance // 3)
        for k in range(count):
            angle = 2 * np.pi * k / count
            yield anchor + distance * np.array([np.cos(angle), 0.8 * np.sin(angle)])


def label(draw, text, anchor, taken, room):
    """Writes it near its anchor, over no other; a line leads to the anchor where it is not on it."""
    width, height = draw.textbbox((0, 0), text, font=FONT)[2:]
    half = np.array([width / 2 + 8, height / 2 + 5])
    for middle in places(np.array(anchor, float), half):
        box = np.concatenate([middle - half, middle + half])
        inside = box[0] >= room[0] and box[1] >= room[1] and box[2] <= room[2] and box[3] <= room[3]
        if inside and not any(box[0] < b[2] and b[0] < box[2] and box[1] < b[3] and b[1] < box[3] for b in taken):
            break
    else:
        raise ValueError(f"no room for the label {text}")
    if not (box[0] <= anchor[0] <= box[2] and box[1] <= anchor[1] <= box[3]):
        draw.line([tuple(middle), tuple(anchor)], fill=BLACK, width=FINER)
        draw.ellipse([anchor[0] - 5, anchor[1] - 5, anchor[0] + 5, anchor[1] + 5], fill=BLACK)
    taken.append(box)
    return middle, box, text


def draw_axes(draw, axes, corner):
    for k, name in enumerate("xyz"):
        tip = corner + np.array([axes[0, k], -axes[1, k]]) * 22 * FINER
        draw.line([tuple(corner), tuple(tip)], fill=GREY, width=FINER)
        end = corner + (tip - corner) * (1 + 9 * FINER / max(np.linalg.norm(tip - corner), 1))
        draw.text(tuple(end), name, font=SMALL, fill=GREY, anchor="mm")


def draw_view(canvas, half, picture, axes, caption, anchors):
    """Puts half a picture in and labels it. `anchors`: place in it by text."""
    left = half * WIDTH * FINER // 2
    canvas.paste(picture, (left, 0))
    draw = ImageDraw.Draw(canvas)
    corner = np.array([left + 34 * FINER, (HEIGHT - 36) * FINER])
    draw_axes(draw, axes, corner)
    draw.text((left + WIDTH * FINER // 4, 12 * FINER), caption, font=SMALL, fill=GREY, anchor="mm")
    room = (left + 4, (ABOVE - 4) * FINER, left + WIDTH * FINER // 2 - 4, (HEIGHT - 4) * FINER)
    taken = [np.concatenate([corner - 34 * FINER, corner + 34 * FINER])]
    put = [label(draw, text, (left + x, y), taken, room) for text, (x, y) in anchors.items()]
    for middle, box, text in put:
        draw.rounded_rectangle(list(box), radius=6, fill="white", outline=BLACK)
        draw.text(tuple(middle), text, font=FONT, fill=BLACK, anchor="mm")


def draw_faces(points, triangles, owner, names):
    """The picture. `points` (n, 3); `triangles` (m, 3) into them, turning outward; `owner` (m): index into
    `names`. ValueError where a face cannot be seen from either side."""
    views = [view_axes(*view[:2]) for view in VIEWS]
    extents = [np.ptp(points @ axes.T, axis=0) for axes in views]
    room = np.array([(WIDTH / 2 - 36) * FINER, (HEIGHT - ABOVE - BELOW) * FINER])
    scale = min((room / extent[:2]).min() for extent in extents)
    halves = [render(points, triangles, owner, axes, scale) for axes in views]
    anchors = [{}, {}]
    for index, name in enumerate(names):
        depths = [distance_transform_edt(face == index) for _, face in halves]
        half = 0 if depths[0].max() >= 0.6 * depths[1].max() else 1
        if depths[half].max() < 2:
            raise ValueError(f"face {name} cannot be seen")
        y, x = np.unravel_index(depths[half].argmax(), depths[half].shape)
        anchors[half][name] = (x, y)
    canvas = Image.new("RGB", (WIDTH * FINER, HEIGHT * FINER), "white")
    for half, (picture, _) in enumerate(halves):
        draw_view(canvas, half, picture, views[half], VIEWS[half][2], anchors[half])
    return canvas.resize((WIDTH, HEIGHT), Image.LANCZOS)
