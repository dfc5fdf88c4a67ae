#!/usr/bin/python3
"""The tree keeps its rules, and each rule finds what it forbids."""
import tempfile
import unittest
from pathlib import Path

import structure

ROOT = Path(__file__).resolve().parents[2]


class TheTree(unittest.TestCase):
    def test_has_sources_to_check(self):
        self.assertGreater(sum(1 for _ in structure.includes(ROOT, "engine")), 50)

    def test_keeps_every_rule(self):
        for rule in structure.RULES:
            with self.subTest(rule=rule.__name__):
                self.assertEqual([], list(rule(ROOT)))


class Rule(unittest.TestCase):
    """A rule on made-up trees of one file with one line."""

    def violations(self, rule, path, line):
        with tempfile.TemporaryDirectory() as root:
            file = Path(root) / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(line + "\n")
            return list(rule(root))

    def allows(self, rule, path, line):
        self.assertEqual([], self.violations(rule, path, line))

    def forbids(self, rule, path, line):
        found = self.violations(rule, path, line)
        self.assertEqual(1, len(found), found)
        self.assertTrue(found[0].startswith(path), found[0])

    def test_a_station_includes_itself_and_earlier_ones_only(self):
        rule = structure.stations_include_only_earlier_ones
        self.allows(rule, "engine/plan/a.cpp", '#include "engine/plan/b.h"')
        self.allows(rule, "engine/plan/a.h", '#include "engine/mesh/b.h"')
        self.forbids(rule, "engine/mesh/a.h", '#include "engine/plan/b.h"')
        self.forbids(rule, "engine/mesh/a.h", '  #  include  "engine/plan/b.h"')
        self.forbids(rule, "engine/mesh/a.h", '#include "server/session/b.h"')
        self.forbids(rule, "engine/mesh/a.h", '#include "b.h"')
        self.forbids(rule, "engine/utils/a.h", "#include <vector>")

    def test_geometry_headers_stand_in_sources_of_the_kernel_only(self):
        rule = structure.geometry_kernels_stay_in_kernel
        for header in ("<BRep_Tool.hxx>", "<TopoDS.lxx>", "<CGAL/Object.h>", "<tetgen.h>", '"tetgen.h"'):
            self.allows(rule, "engine/kernel/a.cpp", "#include " + header)
            self.forbids(rule, "engine/kernel/a.h", "#include " + header)
            self.forbids(rule, "engine/mesh/a.cpp", "#include " + header)
            self.forbids(rule, "server/store/a.cpp", "#include " + header)

    def test_tests_may_use_cgal_but_not_opencascade(self):
        rule = structure.geometry_kernels_stay_in_kernel
        self.allows(rule, "tests/engine/a.cpp", "#include <CGAL/Object.h>")
        self.forbids(rule, "tests/engine/a.cpp", "#include <gp_Pnt.hxx>")

    def test_of_the_server_only_the_service_sees_protobuf(self):
        rule = structure.protocol_stays_in_service
        for header in ('"remesh/v1/remesh.pb.h"', "<google/protobuf/struct.pb.h>"):
            self.allows(rule, "server/service/a.cpp", "#include " + header)
            for path in ("server/session/a.cpp", "server/store/a.h", "server/transport/a.cpp",
                         "engine/base/a.h"):
                self.forbids(rule, path, "#include " + header)

    def test_the_transport_sees_grpc(self):
        rule = structure.protocol_stays_in_service
        self.allows(rule, "server/transport/a.cpp", "#include <grpcpp/server.h>")
        self.forbids(rule, "server/session/a.cpp", "#include <grpcpp/server.h>")

    def test_a_layer_of_the_server_sees_what_lies_inside_it_only(self):
        rule = structure.server_layers_look_inwards
        self.allows(rule, "server/service/a.cpp", '#include "server/store/b.h"')
        self.forbids(rule, "server/store/a.cpp", '#include "server/session/b.h"')
        self.forbids(rule, "server/store/a.cpp", '#include "client/library/b.h"')

    def test_of_the_client_the_service_sees_the_writers_of_mesh_files_alone(self):
        rule = structure.server_layers_look_inwards
        self.allows(rule, "server/service/a.cpp", '#include "remeshd/mesh_file.h"')
        self.allows(rule, "server/service/a.cpp", '#include "client/library/mesh_arrays.h"')
        self.forbids(rule, "server/service/a.cpp", '#include "remeshd/client.h"')
        self.forbids(rule, "server/session/a.cpp", '#include "remeshd/mesh_file.h"')

    def test_sources_that_any_program_may_use_name_their_licence_first(self):
        rule = structure.apache_folders_say_so
        self.allows(rule, "proto/a.h", "// SPDX-License-Identifier: Apache-2.0")
        self.allows(rule, "client/python/a.py", "#!/usr/bin/python3\n# SPDX-License-Identifier: Apache-2.0")
        self.allows(rule, "client/cli/a.h", "#pragma once")
        self.allows(rule, "proto/README.md", "# Protocol")
        for path in ("proto/a.proto", "client/library/a.cpp", "client/include/remeshd/a.h",
                     "client/formats/a.h", "proto/CMakeLists.txt"):
            self.forbids(rule, path, "#pragma once")
        self.forbids(rule, "proto/a.h", "#pragma once\n// SPDX-License-Identifier: Apache-2.0")
        self.forbids(rule, "proto/a.h", "// SPDX-License-Identifier: AGPL-3.0-or-later")
        self.forbids(rule, "proto/a.h", "")

    def test_sources_that_any_program_may_use_include_nothing_under_the_agpl(self):
        rule = structure.apache_folders_include_nothing_else_of_ours
        for header in ('"proto/document.h"', '"remeshd/mesh.h"', '"client/library/status.h"',
                       '"client/formats/text.h"', '"remesh/v1/remesh.pb.h"', "<vector>"):
            self.allows(rule, "client/formats/a.h", "#include " + header)
        for path in ("proto/a.h", "client/library/a.cpp", "client/include/remeshd/a.h",
                     "client/formats/a.cpp"):
            for header in ("engine/base/error.h", "server/daemon.h", "client/cli/run.h"):
                self.forbids(rule, path, f'#include "{header}"')
        self.allows(rule, "client/cli/a.cpp", '#include "engine/base/error.h"')

    def test_a_type_has_one_home_in_a_namespace(self):
        rule = structure.a_type_has_one_home
        with tempfile.TemporaryDirectory() as root:
            for path, text in (("engine/a.h", "namespace remeshd {\nstruct A {\n};"),
                               ("engine/b.h", "namespace remeshd {\nstruct A;\nstruct B {\n};"),
                               ("client/c.h", "namespace remeshd::client {\nclass A {\n};")):
                (Path(root) / path).parent.mkdir(exist_ok=True)
                (Path(root) / path).write_text(text)
            self.assertEqual(list(rule(root)), [])
            (Path(root) / "engine/d.h").write_text("namespace remeshd {\nenum class A : char {\n};")
            self.assertEqual(list(rule(root)), ["engine/d.h:2: A is a type of engine/a.h too"])

    def test_sources_and_folders_of_the_engine_are_small(self):
        rule = structure.engine_rooms_are_small
        self.allows(rule, "engine/mesh/a.cpp", "\n" * 399)
        self.forbids(rule, "engine/mesh/a.cpp", "\n" * 400)
        self.allows(rule, "server/store/a.cpp", "\n" * 401)
        with tempfile.TemporaryDirectory() as root:
            folder = Path(root) / "engine/mesh"
            folder.mkdir(parents=True)
            for k in range(25):
                (folder / f"a{k}.cpp").write_text("")
            self.assertEqual(list(rule(root)), [])
            (folder / "b.h").write_text("")
            self.assertEqual(list(rule(root)), ["engine/mesh: has 26 files, more than 25"])

    def test_no_file_names_a_path_of_one_machine(self):
        rule = structure.no_path_of_one_machine
        self.allows(rule, "README.md", "client/" + "work/a, $HOME/" + "work/b, https://a.b/" + "work/")
        self.forbids(rule, "README.md", "see /" + "home/me/build")
        self.allows(rule, "tests/a_test.cpp", '"/' + 'home/anna/x"')
        self.forbids(rule, "deploy/a.sh", "cd '/" + "root/x'")


if __name__ == "__main__":
    unittest.main()
