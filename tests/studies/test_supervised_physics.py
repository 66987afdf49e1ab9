"""Live physics against the supervisor's model; minutes long, run by `make study`."""

import pytest

from prospect_mj.actions.action import Action
from prospect_mj.experiment.studies.supervisor_study import table, watched_in_parallel
from prospect_mj.supervisor.plant import plant, supervision
from prospect_mj.supervisor.supervisor import MODES, Supervisor
from prospect_mj.task.pick_place import TaskSettings

pytestmark = [pytest.mark.slow, pytest.mark.gl]
EPISODES = 500


@pytest.fixture(scope="module", params=MODES)
def episodes(request):
    return watched_in_parallel(TaskSettings(), request.param, EPISODES, jobs=2)


def test_every_observed_event_was_foreseen(episodes, capsys):
    with capsys.disabled():
        inserted = sum(episode.inserted for episode in episodes)
        print(f"\n{len(episodes)} episodes, mode {episodes[0].mode}: ", end="")
        print(f"{inserted} inserted")
        print(table(episodes))
    assert len(episodes) == EPISODES
    surprises = {e.seed: e.unforeseen for e in episodes if e.unforeseen}
    assert not surprises


def test_the_automaton_accepts_every_episode_as_a_whole(episodes):
    """The supervised one and the bare plant, from the first look to the end."""
    for automaton in (supervision().automaton, plant()):
        for episode in episodes:
            run = automaton.run(episode.word)
            assert run.refused is None, episode.seed
            assert run.state.predicates == episode.steps[-1].after


def test_no_forbidden_state_between_two_actions(episodes):
    assert not {e.seed: e.forbidden for e in episodes if e.forbidden}


def test_the_policy_kept_to_the_choice_set(episodes):
    for episode in episodes:
        supervisor = Supervisor(episode.mode)
        for step in episode.steps:
            mask = supervisor.choice_set(step.before)
            assert step.action in {a.label for a in Action if mask[a]}


def test_many_kinds_of_events_were_seen(episodes):
    """Otherwise the tests above would say little."""
    seen = {(s.action, s.result) for e in episodes for s in e.steps}
    results = {result for _, result in seen}
    assert {"success", "jammed"} <= results
    assert {action for action, _ in seen} == {
        "grasp-left",
        "grasp-right",
        "swap-left-to-right",
        "swap-right-to-left",
        "insert-left",
        "insert-right",
    }
    assert ("not_allowed" in results) == (episodes[0].mode != "productive")
