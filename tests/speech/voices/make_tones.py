"""Makes `tones.onnx` beside it, a voice in piper's form without a word of training: each phoneme is a tone of its own.

`pip install 'piper-tts[alignment]'`, then run it. It lets piper itself, its phonemes, lengths and noise be tested where
no voice can be had; what it says nobody understands.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper
from piper.phoneme_ids import DEFAULT_PHONEME_ID_MAP

RATE, HOP = 22_050, 256
FRAMES = 6
"""Hops of each phoneme, and of each pause behind one: 70 ms."""

NUMBERS = {
    "first": np.array([0], np.int64),
    "second": np.array([1], np.int64),
    "third": np.array([2], np.int64),
    "zero": np.array(0, np.int64),
    "one": np.array(1, np.int64),
    "hop": np.array(HOP, np.int64),
    "nothing": np.array(0, np.float32),
    "frames": np.array(FRAMES, np.float32),
    "turn": np.array(2 * np.pi / RATE * 10, np.float32),
    "quiet": np.array(0.1, np.float32),
    "column": np.array([-1, 1], np.int64),
    "sound": np.array([1, 1, 1, -1], np.int64),
}

NODES = (
    ("Slice", "scales first second", "noise_scales"),
    ("Squeeze", "noise_scales", "noise_scale"),
    ("Slice", "scales second third", "length_scales"),
    ("Squeeze", "length_scales", "length_scale"),
    ("Mul", "frames length_scale", "width"),
    ("Cast", "input", "ids"),
    ("Mul", "ids nothing", "zeros"),
    ("Add", "zeros width", "widths"),
    ("Ceil", "widths", "w_ceil"),
    ("ReduceMax", "w_ceil", "widest"),
    ("Cast", "widest", "hops"),
    ("Mul", "hops hop", "samples"),
    ("Range", "zero samples one", "counted"),
    ("Cast", "counted", "times"),
    ("Reshape", "ids column", "rows"),
    ("Mul", "times turn", "angles"),
    ("Mul", "rows angles", "phases"),
    ("Sin", "phases", "tones"),
    ("RandomNormalLike", "tones", "noise"),
    ("Mul", "noise noise_scale", "breath"),
    ("Mul", "breath quiet", "breathed"),
    ("Add", "tones breathed", "mixed"),
    ("Reshape", "mixed sound", "output"),
)
OPTIONS = {
    "ids": {"to": TensorProto.FLOAT},
    "hops": {"to": TensorProto.INT64},
    "times": {"to": TensorProto.FLOAT},
    "widest": {"keepdims": 0},
}


def main() -> None:
    path = Path(__file__).with_name("tones.onnx")
    nodes = [helper.make_node(kind, taken.split(), [made], **OPTIONS.get(made, {})) for kind, taken, made in NODES]
    inputs = [
        helper.make_tensor_value_info("input", TensorProto.INT64, [1, "phonemes"]),
        helper.make_tensor_value_info("input_lengths", TensorProto.INT64, [1]),
        helper.make_tensor_value_info("scales", TensorProto.FLOAT, [3]),
    ]
    output = helper.make_tensor_value_info("output", TensorProto.FLOAT, [1, 1, 1, "samples"])
    numbers = [numpy_helper.from_array(value, name) for name, value in NUMBERS.items()]
    graph = helper.make_graph(nodes, "tones", inputs, [output], numbers)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)])
    model.ir_version = 8
    onnx.checker.check_model(model)
    onnx.save(model, path)
    told = {
        "audio": {"sample_rate": RATE},
        "espeak": {"voice": "en-us"},
        "language": {"code": "en_US"},
        "phoneme_type": "espeak",
        "phoneme_id_map": DEFAULT_PHONEME_ID_MAP,
        "num_symbols": 256,
        "num_speakers": 1,
        "inference": {"noise_scale": 0.667, "length_scale": 1, "noise_w": 0.8},
    }
    path.with_name(f"{path.name}.json").write_text(json.dumps(told) + "\n", "utf-8")


if __name__ == "__main__":
    main()
