"""The simulation: scene, live physics, cameras; it knows no task and no controller."""
