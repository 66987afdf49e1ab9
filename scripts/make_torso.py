"""Write models/torso.xml from one arm and one hand."""

from prospect_mj.paths import MODELS
from prospect_mj.robot.description.torso import torso_xml

if __name__ == "__main__":
    path = MODELS / "torso.xml"
    path.write_text(torso_xml())
    print(f"wrote {path.name}")
