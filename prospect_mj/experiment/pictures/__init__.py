"""Pictures of the scene, of planning and of the automaton."""
