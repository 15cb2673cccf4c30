pub mod contour;
pub mod distance;
pub mod error;
pub mod grid;
pub mod small;
