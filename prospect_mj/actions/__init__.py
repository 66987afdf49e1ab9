"""The six high-level actions, as plans over the controllers."""
