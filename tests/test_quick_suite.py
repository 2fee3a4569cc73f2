"""`make test` covers every command, core, language and URL scheme at least once on real input.

Slow tests are marked `slow` and run in `make test-all`. For each feature, the tables name a test that stays in
`make test`.
"""

import ast
import re
from pathlib import Path

import pytest

from unity_link.cli.families import FAMILIES
from unity_link.generate import TARGETS

ROOT = Path(__file__).parent.parent
COMMANDS = {
    "build": "tests/boards/test_own_top.py::test_build_makes_a_project_of_a_users_top_and_prints_its_warnings",
    "check": "tests/cli/test_spec.py::test_check_reports_a_valid_spec",
    "demo": "tests/cli/test_full_screen.py::test_the_demo_on_a_terminal_that_can_draw_nothing_prints_lines",
    "doctor": "tests/doctor/test_faults.py::test_mapped_memory_has_no_gateway_to_examine",
    "example": "tests/cli/test_example.py::test_an_example_is_written_and_a_changed_file_is_kept",
    "explain": "tests/cli/test_explain.py::test_json_has_an_object_for_each_frame_and_the_summary",
    "export": "tests/cli/test_spec.py::test_systemrdl_goes_out_and_in",
    "find": "tests/cli/test_find.py::test_simulated_boards_are_listed_with_name_map_and_session",
    "fmt": "tests/cli/test_spec.py::test_fmt_changes_a_file_once",
    "ft232h": "tests/cli/test_ft232h.py::test_contents_of_an_eeprom_are_shown",
    "gateware": "tests/generate/test_vhdl_folder.py::test_a_folder_with_files_is_left_as_it_is",
    "generate": "tests/cli/test_spec.py::test_generate_writes_and_lists_the_files",
    "get": "tests/cli/test_signals.py::test_signals_are_read_by_name_part_and_pattern_in_their_units",
    "import": "tests/cli/test_spec.py::test_systemrdl_goes_out_and_in",
    "info": "tests/cli/test_commands.py::test_output_for_programs_is_json",
    "live": "tests/bridges/test_live.py::test_a_slider_is_moved_by_the_keyboard_and_writes_within_the_limits",
    "read": "tests/bridges/test_serve_command.py::test_tcp_listens_on_this_machine_alone",
    "record": "tests/cli/test_manual.py::test_recording_is_described_as_json",
    "replay": "tests/bridges/test_recording.py::test_a_replay_is_served_to_other_programs",
    "retrace": "tests/virtual/test_retrace.py::test_the_complete_records_of_a_cut_file_are_replayed",
    "ros1": "tests/bridges/test_ros1.py::test_one_message_sets_all_joints_and_one_that_is_wrong_sets_none",
    "ros2": "tests/bridges/test_ros2.py::test_one_message_sets_all_joints_and_one_that_is_wrong_sets_none",
    "serve": "tests/bridges/test_serve_command.py::test_tcp_listens_on_this_machine_alone",
    "set": "tests/cli/test_signals.py::test_signals_are_written_by_name_with_units_names_and_truths",
    "show": "tests/cli/test_spec.py::test_show_gives_a_tree_with_addresses",
    "simulate": "tests/cli/test_find.py::test_simulated_boards_are_listed_with_name_map_and_session",
    "stop": "tests/cli/test_signals.py::test_stop_disarms_all_leases_of_a_spec_given_in_any_way",
    "terminal": "tests/cli/test_terminal.py::test_typed_requests_are_sent_and_answers_explained_until_ctrl_d",
    "watch": "tests/cli/test_full_screen.py::test_watch_shows_values_as_they_change_through_resizes",
    "write": "tests/link/test_mapped.py::test_commands_take_the_url",
    "zenoh": "tests/bridges/test_zenoh.py::test_signals_are_read_and_written_by_keys_in_batches_and_by_wildcards",
}
CORES = {
    "encoder": "gateware/cores/encoder/test_encoder.py::test_an_encoder_is_its_model",
    "gpio": "gateware/cores/gpio/test_gpio.py::test_it_is_as_the_model_in_every_cycle",
    "lease": "gateware/cores/lease/test_lease.py::test_it_is_as_the_model_in_every_cycle",
    "pwm": "gateware/cores/pwm/test_pwm.py::test_the_pins_are_those_of_the_model",
    "schedule": "gateware/cores/schedule/test_schedule.py::test_it_is_as_the_model_in_every_cycle",
    "stepgen": "gateware/cores/stepgen/test_stepgen.py::test_all_outputs_are_those_of_the_model",
}
LANGUAGES = {
    "c": "tests/generate/test_c.py::test_words_blocks_batches_and_posted_writes_arrive",
    "cpp": "tests/generate/test_cpp.py::test_values_of_every_kind_are_encoded_and_decoded_as_in_python",
    "docs": "tests/generate/test_docs.py::test_page_has_every_property_of_a_signal",
    "matlab": "tests/generate/test_matlab.py::test_signals_work_within_their_kind_access_and_place",
    "python": "tests/generate/test_python.py::test_the_generated_scara_reads_writes_and_is_published",
    "ros1": "tests/generate/test_ros.py::test_the_program_of_a_package_becomes_the_bridge_with_its_spec",
    "ros2": "tests/generate/test_ros.py::test_the_program_of_a_package_becomes_the_bridge_with_its_spec",
    "verilog": "tests/generate/test_verilog.py::test_netlist_has_the_requested_clock_and_baud_rate",
    "vhdl": "tests/generate/test_vhdl.py::test_gateway_and_boards_elaborate_with_the_gateware",
}
SCHEMES = {
    "ftdi": "tests/transport/test_ft232h.py::test_a_virtual_chip_needs_only_its_url",
    "ftdi-async": "tests/transport/test_ft232h.py::test_a_chip_unplugged_while_it_is_opened_is_reported",
    "mmio": "tests/link/test_mapped.py::test_commands_take_the_url",
    "rtl": "tests/virtual/test_rtl.py::test_memory_has_the_words_that_requests_read_and_write",
    "serial": "tests/bridges/test_serve_nodes.py::test_each_node_has_its_own_socket_and_port",
    "sim": "tests/cli/test_signals.py::test_signals_are_read_by_name_part_and_pattern_in_their_units",
    "tcp": "tests/bridges/test_serve_command.py::test_tcp_listens_on_this_machine_alone",
    "udp": "tests/cli/test_find.py::test_a_board_is_given_an_address_and_shown_with_it",
    "unix": "tests/cli/test_full_screen.py::test_watch_shows_values_as_they_change_through_resizes",
    "zenoh": "tests/bridges/test_zenoh.py::test_a_link_over_zenoh_is_a_link_like_any_other",
}
FEATURES = {**COMMANDS, **CORES, **LANGUAGES, **SCHEMES}


def test_the_tables_name_every_command_core_language_and_scheme() -> None:
    drivers = (ROOT / "docs" / "drivers.md").read_text(encoding="utf-8")
    table = drivers.partition("\n\n## ")[0]
    assert COMMANDS.keys() == FAMILIES.keys()
    assert CORES.keys() == {path.parent.name for path in (ROOT / "gateware" / "cores").glob("*/core.toml")}
    assert LANGUAGES.keys() == set(TARGETS)
    assert SCHEMES.keys() == set(re.findall(r"`([a-z-]+):", "".join(re.findall(r"^\| (.*?) \|", table, re.MULTILINE))))


@pytest.mark.parametrize("test", sorted(set(FEATURES.values())))
def test_a_test_of_the_tables_is_in_make_test(test: str) -> None:
    file, _, name = test.partition("::")
    tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
    marks = [
        ast.unparse(node.value)
        for node in tree.body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "pytestmark"
    ]
    (function,) = (
        node for node in tree.body if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and node.name == name
    )
    # Ignore the marks of single parameters: a parameter may be slow if another one is not.
    marks += [ast.unparse(decorator) for decorator in function.decorator_list if "param" not in ast.unparse(decorator)]
    assert not {"pytest.mark.slow", "pytest.mark.campaign"} & set(re.findall(r"pytest\.mark\.\w+", " ".join(marks)))
