"""Deep learners of Stable-Baselines3 on recorded physics."""
