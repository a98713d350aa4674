"""JSON whose members are also attributes: result.by_kind.vertex.cases."""
import json
import re


class Fields(dict):
    def __getattr__(self, name):
        if name not in self:
            raise AttributeError(f"no member {name}")
        return self[name]

    __setattr__ = dict.__setitem__
    __delattr__ = dict.__delitem__


def read(file):
    """A JSON file, or the data of a page of mmverify report."""
    with open(file, encoding="utf-8") as opened:
        text = opened.read()
    page = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
    return json.loads(page[1] if page else text, object_hook=Fields)


def names_of(value):
    """What an expression may name: `it`, the whole value, and the members of an object."""
    return {**(value if isinstance(value, dict) else {}), "it": value}
