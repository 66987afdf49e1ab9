"""Write assets/jar.obj and its texture assets/jar.png: what the camera sees."""

from prospect_mj.paths import ASSETS
from prospect_mj.sim.jar_files import write

if __name__ == "__main__":
    write(ASSETS)
    print("wrote jar.obj and jar.png")
