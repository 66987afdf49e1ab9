"""Which presentation a node belongs to."""

import numpy as np
from ideal_recording import ideal, recording


def test_every_node_is_in_the_tree_of_the_root_that_leads_to_it():
    made = recording(left=(ideal, ideal), right=(ideal,))
    child, reached = made.nodes.child, []
    for number, root in enumerate(made.presentations.root):
        waiting, tree = [int(root)], set()
        while waiting:
            tree.add(node := waiting.pop())
            waiting += [int(n) for n in child[node] if n >= 0 and n not in tree]
        of = made.presentation_of(np.array(sorted(tree)))
        assert set(of) == {number}
        reached += tree
    assert sorted(reached) == list(range(len(child)))
