"""The cells mode of tracked fronts: a moving mesh whose faces include every front, a finite-volume method between them."""
