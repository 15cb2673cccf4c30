# Rscript examples/morphometrics.R matches/
#
# Reads what `thinshell match … --out matches/` has written by R's own functions, and computes the table's centroid sizes and
# Procrustes distances again from the points.

folder <- commandArgs(trailingOnly = TRUE)[1]
points <- read.csv(file.path(folder, "semilandmarks.csv"))
table <- read.csv(file.path(folder, "table.csv"))
table <- table[table$matched == "yes", ]

shapes <- lapply(
  split(points[c("x", "y")], factor(points$shape, levels = unique(points$shape))),
  as.matrix
)
size <- function(shape) sqrt(sum(scale(shape, scale = FALSE)^2))
unit <- function(shape) scale(shape, scale = FALSE) / size(shape)

# Of rotations, not of reflections: the last singular value counts by the sign of the determinant.
distance <- function(a, b) {
  parts <- svd(t(unit(a)) %*% unit(b))
  turn <- sign(det(parts$u) * det(parts$v))
  sqrt(max(0, 2 - 2 * sum(parts$d * c(1, turn))))
}

sizes <- sapply(shapes[-1], size)
distances <- sapply(shapes[-1], function(shape) distance(shapes[[1]], shape))
off <- c(max(abs(sizes / table$centroid_size - 1)), max(abs(distances - table$procrustes_distance)))
cat(sprintf("%d shapes of %d points; sizes agree to %.0e, distances to %.0e.\n",
  length(sizes), nrow(shapes[[1]]), off[1], off[2]))
# Near 0 the root has lost half of the digits.
if (any(off > c(1e-10, 1e-6))) quit(status = 1)
