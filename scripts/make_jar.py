"""Write assets/jar.obj and its texture assets/jar.png: what the camera sees."""

from prospect_mj.experiment.jar_files import write
from prospect_mj.paths import ASSETS

if __name__ == "__main__":
    write(ASSETS)
    print("wrote jar.obj and jar.png")
