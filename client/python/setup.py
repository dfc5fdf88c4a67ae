# SPDX-License-Identifier: Apache-2.0
"""Builds the package with pip out of the source tree; CMake does the same without pip.

Needs protoc and grpc_python_plugin (Debian: protobuf-compiler, protobuf-compiler-grpc).
"""
import shutil
import sys
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from generate import generate  # noqa: E402


class BuildWithProtocol(build_py):
    """Adds the code of the protocol to what is built."""

    def run(self) -> None:
        super().run()
        protoc, plugin = shutil.which("protoc"), shutil.which("grpc_python_plugin")
        if protoc is None or plugin is None:
            sys.exit("remesh-client is built with protoc and grpc_python_plugin; one is missing")
        generate(HERE.parent.parent / "proto", Path(self.build_lib) / "remesh_client/v1", protoc,
                 plugin)


setup(cmdclass={"build_py": BuildWithProtocol})
