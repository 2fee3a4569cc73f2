"""The ranges of numbers in models compiled elsewhere: every model of this compiler is within them."""

import pytest
from hypothesis import HealthCheck, given, settings

from support.searching import examples
from support.spec_examples import specs
from unity_link.spec import compile_text
from unity_link.spec.printer import print_file
from unity_link.spec.ranges import check_ranges
from unity_link.spec.syntax import File


@pytest.mark.slow
@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.too_slow])
@given(specs())
def test_every_spec_that_compiles_has_its_numbers_in_their_ranges(file: File) -> None:
    check_ranges(compile_text(print_file(file)).interface())
