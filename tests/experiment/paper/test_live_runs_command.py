import pytest

from prospect_mj.cli import live_runs as command


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ("--runs 0", "runs is 0"),
        ("--runs -1", "runs is -1"),
        ("--trials 0", "trials is 0"),
        ("--jobs 0", "jobs is 0"),
        ("--backend ray", "--backend"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(
    tmp_path, monkeypatch, capsys, options, message
):
    monkeypatch.chdir(tmp_path)
    assert command.main(options.split()) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("error: ")
    assert message in line
    assert not list(tmp_path.iterdir())
