"""A part of each type of features, for its picture and its JSON on the page. A new type needs one here."""

SAMPLES = {
    "block": {"dx": 60, "dy": 40, "dz": 30},
    "cylinder": {"radius": 20, "height": 40},
    "cone": {"radius_bottom": 25, "radius_top": 12, "height": 40},
    "sphere": {"radius": 25},
    "torus": {"major_radius": 25, "minor_radius": 9},
    "prism": {"profile": [[-30, -18], [30, -18], [30, 4],
                          {"to": [10, 24], "through": ["10 + 20*cos(45*deg)", "4 + 20*sin(45*deg)"]},
                          [-30, 24]],
              "height": 25},
    "revolution": {"profile": [[10, 0], [28, 0], [28, 12], [18, 12], [18, 30], [10, 30]], "angle": 270},
    "slot": {"length": 60, "width": 26, "height": 20},
}


def feature(type_name):
    """The feature; KeyError where the type has no sample."""
    return {"id": "part", "nature": "ADDITIVE", "type": type_name, "parameters": SAMPLES[type_name]}


def model(type_name):
    return {"name": f"sample-{type_name}", "features": [feature(type_name)]}


def faces(kind):
    """Names of the sample's faces, of a type as `remesh types --json` tells it: `side#` stands for one a side."""
    sides = len(SAMPLES[kind["name"]].get("profile", []))
    names = []
    for name in kind["faces"]:
        names += [name.replace("#", str(k + 1)) for k in range(sides)] if "#" in name else [name]
    return names
