"""Skills as a library: run one on a live simulation, and read what came of it."""

from prospect_mj.skills.sensors import Sensors, Trajectory
from prospect_mj.skills.skill import Skill
from prospect_mj.skills.skill_run import SkillRun
from prospect_mj.skills.workbench import Workbench

__all__ = ["Sensors", "Skill", "SkillRun", "Trajectory", "Workbench"]
