import numpy as np
import pytest

from prospect_mj.vision.segmentation import Region, SegmentationSettings, segment

TABLES = {"dark": (20, 20, 22), "tan": (150, 125, 100), "green": (30, 90, 50)}


def picture(table, thing, rng):
    """A thing on a table that is lit on the left and in shadow on the right."""
    image = np.empty((120, 160, 3))
    image[:] = table
    image *= np.linspace(1.0, 0.4, 160)[None, :, None]
    image[40:80, 50:110] = thing
    image += rng.normal(0, 2, image.shape)
    return np.clip(np.rint(image), 0, 255).astype(np.uint8)


@pytest.mark.parametrize("thing", [(230, 230, 220), (190, 30, 30), (30, 50, 165)])
@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_finds_the_object_on_any_table(table, thing):
    mask = segment(
        picture(table, thing, np.random.default_rng(0)), SegmentationSettings()
    )
    true = np.zeros_like(mask)
    true[40:80, 50:110] = 1
    overlap = (mask & true).sum() / (mask | true).sum()
    assert overlap > 0.85


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_light_and_shadow_on_the_table_are_no_object(table):
    image = picture(table, (0, 0, 0), np.random.default_rng(1))
    assert segment(image, SegmentationSettings()).sum() < 100


def test_keeps_the_largest_thing_only():
    image = picture(TABLES["dark"], (230, 230, 220), np.random.default_rng(2))
    image[10:16, 130:140] = 255
    mask = segment(image, SegmentationSettings())
    assert mask[60, 80] == 1
    assert mask[13, 135] == 0


def test_region_crops_rows_and_columns():
    image = np.arange(20).reshape(4, 5)
    assert Region(1, 2, 3, 2).crop(image).tolist() == [[11, 12, 13], [16, 17, 18]]
