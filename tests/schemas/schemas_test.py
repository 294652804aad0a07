"""The JSON Schemas of scenes: schemas_test.py SOURCE_FOLDER

Each example fits its schema. Of the broken files those in SEEN_BY_READER_ONLY are beyond what a schema can know; all
others have to fail. Types of objects are those of compiler/scene/objects.def, with their counts of numbers.
"""

import json
import pathlib
import re
import sys

import jsonschema

KINDS = ("scene", "model", "material", "shader", "primitive")
# Names that stand elsewhere, documents, code, clashes, vectors that are zero, and sizes are no matter of schemas.
SEEN_BY_READER_ONLY = {
    "camera_up.scene.json", "code_lines.shader.json", "code_string.primitive.json", "flat.scene.json",
    "relation.scene.json", "two_dynamic.scene.json", "cycle.scene.json", "cycle_a.model.json", "cycle_b.model.json", "document.material.json",
    "document_constant.material.json", "document_missing.material.json", "flat_scale.scene.json", "id_clash.scene.json",
    "missing_model.scene.json", "no_function.primitive.json", "no_shade.shader.json", "too_deep.scene.json",
    "too_many.scene.json", "twice.scene.json", "two_names.scene.json",
} | {f"doubling_{i}.model.json" for i in range(13)}


def main(source):
    root = pathlib.Path(source)
    validators = {}
    faults = []
    for kind in KINDS:
        schema = json.loads((root / f"docs/schemas/{kind}.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        validators[kind] = jsonschema.Draft7Validator(schema)

    def problem(path):
        try:
            data = json.loads(path.read_text(), strict=False)  # line breaks in strings are fine
        except json.JSONDecodeError as error:
            return str(error)
        error = jsonschema.exceptions.best_match(validators[path.name.split(".")[-2]].iter_errors(data))
        return None if error is None else f"{error.json_path}: {error.message}"

    examples = sorted((root / "docs/gallery/scenes").glob("*.json"))
    if len(examples) < 25:
        faults.append("there are too few examples")
    for path in examples:
        if (found := problem(path)) is not None:
            faults.append(f"{path.name}: {found}")
    for path in sorted((root / "tests/data/scenes/broken").glob("*.json")):
        fits = problem(path) is None
        if fits != (path.name in SEEN_BY_READER_ONLY):
            faults.append(f"{path.name}: {'fits its schema' if fits else problem(path)}")

    table = (root / "compiler/scene/objects.def").read_text()
    objects = re.findall(r'^SCENE_OBJECT\(\w+, \w+, \d+, "([^"]+)", \w+,\s*DATA\((.*?)\),\s*"', table, re.S | re.M)
    scene = json.loads((root / "docs/schemas/scene.schema.json").read_text())
    shape = scene["definitions"]["object"]
    if [name for name, _ in objects] != shape["properties"]["type"]["anyOf"][0]["enum"]:
        faults.append("the types of the schema are not those of objects.def")
    counts = {rule["if"]["properties"]["type"]["const"]: rule["then"]["properties"]["data"]["maxItems"]
              for rule in shape["allOf"] if "type" in rule["if"]["properties"]}
    for name, data in objects:
        if counts.get(name) != data.count("NUMBER("):
            faults.append(f"{name} has {data.count('NUMBER(')} numbers, in the schema {counts.get(name)}")
    if not objects:
        faults.append("objects.def cannot be read")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


sys.exit(main(sys.argv[1]))
