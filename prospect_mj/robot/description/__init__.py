"""The torso's MJCF, written from one arm and one hand; the sides are reflections.

Reflection in the sagittal plane maps a link's local point (x, y, z) to (x, -y, z),
keeps the sign of joints about y and flips that of joints about z.
"""
