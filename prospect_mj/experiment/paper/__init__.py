"""The paper's experiment at its full size, on recorded physics."""
