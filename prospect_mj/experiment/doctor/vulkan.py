"""`python -m prospect_mj.experiment.doctor.vulkan`: the devices Vulkan can draw on.

Rerun's viewer draws by Vulkan. This is a process of its own, which a broken driver may
take down with it.
"""

import ctypes
import sys

_LOADER = "libvulkan.so.1"
_INSTANCE_CREATE_INFO = 1
"""VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, in Vulkan's vulkan_core.h."""


class _InstanceCreateInfo(ctypes.Structure):
    """VkInstanceCreateInfo, in vulkan_core.h, too."""

    _fields_ = (
        ("type", ctypes.c_int32),
        ("next", ctypes.c_void_p),
        ("flags", ctypes.c_uint32),
        ("application", ctypes.c_void_p),
        ("n_layers", ctypes.c_uint32),
        ("layers", ctypes.c_void_p),
        ("n_extensions", ctypes.c_uint32),
        ("extensions", ctypes.c_void_p),
    )


def main() -> int:
    """Print the number and return 0; or say what is missing and return 1."""
    try:
        n_found = n_devices()
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    print(n_found)
    return 0


def n_devices() -> int:
    """Devices of all drivers; 0 where there is no driver.

    Raises:
        OSError: if Vulkan itself is not installed.
    """
    vulkan = ctypes.CDLL(_LOADER)
    info, instance = _InstanceCreateInfo(_INSTANCE_CREATE_INFO), ctypes.c_void_p()
    if vulkan.vkCreateInstance(ctypes.byref(info), None, ctypes.byref(instance)) != 0:
        return 0
    number = ctypes.c_uint32()
    vulkan.vkEnumeratePhysicalDevices(instance, ctypes.byref(number), None)
    vulkan.vkDestroyInstance(instance, None)
    return number.value


if __name__ == "__main__":
    sys.exit(main())
