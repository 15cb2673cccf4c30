//! Numbers of a shader, and what is done with them.

use naga::{BinaryOperator, Handle, Literal, MathFunction, ScalarKind, Type, UnaryOperator};

#[derive(Clone, Debug)]
pub enum Value {
    Float(f64),
    Whole(u32),
    Signed(i32),
    Truth(bool),
    /// Of a vector, a matrix, an array or a structure.
    Many(Vec<Value>),
    /// A part of a local variable.
    Place(usize, Vec<usize>),
    /// A part of an array on the card: zeros, and what is written there is lost.
    Stored(Handle<Type>),
}
use Value::{Float, Many, Signed, Truth, Whole};

impl Value {
    pub fn zero(kind: ScalarKind) -> Self {
        match kind {
            ScalarKind::Float => Float(0.0),
            ScalarKind::Uint => Whole(0),
            ScalarKind::Sint => Signed(0),
            _ => Truth(false),
        }
    }

    pub fn of(literal: Literal) -> Self {
        match literal {
            Literal::F32(x) => Float(f64::from(x)),
            Literal::U32(x) => Whole(x),
            Literal::I32(x) => Signed(x),
            Literal::Bool(x) => Truth(x),
            other => panic!("{other:?} is no number of a shader here"),
        }
    }

    pub fn parts(&self) -> &[Value] {
        match self {
            Many(parts) => parts,
            one => std::slice::from_ref(one),
        }
    }

    pub fn parts_mut(&mut self) -> &mut [Value] {
        match self {
            Many(parts) => parts,
            one => std::slice::from_mut(one),
        }
    }

    pub fn is(&self) -> bool {
        matches!(self, Truth(true))
    }

    /// How many floats it has.
    pub fn floats(&self) -> u64 {
        match self {
            Float(_) => 1,
            Many(parts) => parts.iter().map(Self::floats).sum(),
            _ => 0,
        }
    }

    fn is_matrix(&self) -> bool {
        matches!(self, Many(parts) if matches!(parts[0], Many(_)))
    }

    fn each(&self, f: &impl Fn(&Value) -> Value) -> Value {
        match self {
            Many(parts) => Many(parts.iter().map(|part| part.each(f)).collect()),
            one => f(one),
        }
    }

    /// Number by number; a number goes with all of many.
    fn with(&self, other: &Self, f: &impl Fn(&Value, &Value) -> Value) -> Value {
        match (self, other) {
            (Many(a), Many(b)) => Many(a.iter().zip(b).map(|(a, b)| a.with(b, f)).collect()),
            (Many(a), b) => Many(a.iter().map(|a| a.with(b, f)).collect()),
            (a, Many(b)) => Many(b.iter().map(|b| a.with(b, f)).collect()),
            (a, b) => f(a, b),
        }
    }

    pub fn unary(&self, op: UnaryOperator) -> Value {
        self.each(&|x| match (op, x) {
            (UnaryOperator::Negate, Float(x)) => Float(-x),
            (UnaryOperator::Negate, Signed(x)) => Signed(-x),
            (UnaryOperator::LogicalNot, Truth(x)) => Truth(!x),
            other => panic!("{other:?} is in no shader here"),
        })
    }

    pub fn converted(&self, kind: ScalarKind) -> Value {
        self.each(&|x| {
            let x = match *x {
                Float(x) => x,
                Whole(x) => f64::from(x),
                Signed(x) => f64::from(x),
                ref other => panic!("{other:?} is no number"),
            };
            match kind {
                ScalarKind::Float => Float(x),
                ScalarKind::Uint => Whole(x as i64 as u32),
                _ => Signed(x as i64 as i32),
            }
        })
    }

    pub fn selected(&self, accept: &Value, reject: &Value) -> Value {
        match self {
            Many(truths) => {
                let parts = accept.parts().iter().zip(reject.parts());
                Many(truths.iter().zip(parts).map(|(truth, (a, b))| truth.selected(a, b)).collect())
            }
            truth => if truth.is() { accept } else { reject }.clone(),
        }
    }

    fn dot(&self, other: &Value) -> Value {
        let product = |(a, b): (&Value, &Value)| match (a, b) {
            (Float(a), Float(b)) => a * b,
            other => panic!("{other:?} are no floats"),
        };
        Float(self.parts().iter().zip(other.parts()).map(product).sum())
    }

    fn transposed(&self) -> Value {
        let columns = self.parts();
        let row = |k: usize| Many(columns.iter().map(|column| column.parts()[k].clone()).collect());
        Many((0..columns[0].parts().len()).map(row).collect())
    }

    /// Also how many operations on floats that takes.
    pub fn binary(&self, op: BinaryOperator, other: &Value) -> (Value, u64) {
        // A matrix is its columns: m v has dot products with the rows, v m with the columns.
        let dots = |rows: &Value, v: &Value| {
            let image = Many(rows.parts().iter().map(|row| row.dot(v)).collect());
            (image, (2 * v.floats() - 1) * rows.parts().len() as u64)
        };
        if op == BinaryOperator::Multiply {
            match (self.is_matrix(), other.is_matrix()) {
                (true, true) => {
                    let rows = self.transposed();
                    let columns = other.parts().iter().map(|column| dots(&rows, column));
                    let (columns, operations): (Vec<_>, Vec<_>) = columns.unzip();
                    return (Many(columns), operations.iter().sum());
                }
                (true, false) if matches!(other, Many(_)) => return dots(&self.transposed(), other),
                (false, true) if matches!(self, Many(_)) => return dots(other, self),
                _ => {}
            }
        }
        let result = self.with(other, &|a, b| one(op, a, b));
        let operations = result.floats();
        (result, operations)
    }

    pub fn math(&self, fun: MathFunction, second: Option<&Value>, third: Option<&Value>) -> (Value, u64) {
        use MathFunction as Fun;
        let second = second.unwrap_or(self);
        let float = |f: fn(f64) -> f64| {
            self.each(&|x| match x {
                Float(x) => Float(f(*x)),
                Signed(x) => Signed(x.abs()),
                other => panic!("{other:?} is no float"),
            })
        };
        let least = |a: &Value, b: &Value| a.with(b, &|a, b| one(BinaryOperator::Less, a, b).selected(a, b));
        let most = |a: &Value, b: &Value| a.with(b, &|a, b| one(BinaryOperator::Less, a, b).selected(b, a));
        let count = self.floats();
        match fun {
            Fun::Abs => (float(f64::abs), 0),
            Fun::Floor => (float(f64::floor), 0),
            Fun::Round => (float(f64::round_ties_even), 0),
            Fun::Sqrt => (float(f64::sqrt), count),
            Fun::Exp2 => (float(f64::exp2), count),
            Fun::Min => (least(self, second), 0),
            Fun::Max => (most(self, second), 0),
            Fun::Clamp => (least(&most(self, second), third.expect("two bounds")), 0),
            Fun::Transpose => (self.transposed(), 0),
            Fun::Dot => (self.dot(second), 2 * count - 1),
            Fun::Length => (self.dot(self).math(Fun::Sqrt, None, None).0, 2 * count),
            Fun::Cross => {
                let (a, b) = (self.parts(), second.parts());
                let product = |i: usize, j: usize| one(BinaryOperator::Multiply, &a[i], &b[j]);
                let part = |i, j| one(BinaryOperator::Subtract, &product(i, j), &product(j, i));
                (Many(vec![part(1, 2), part(2, 0), part(0, 1)]), 9)
            }
            other => panic!("{other:?} is in no shader here"),
        }
    }
}

/// Of two numbers of a kind.
fn one(op: BinaryOperator, a: &Value, b: &Value) -> Value {
    use BinaryOperator as Op;
    let compared = |order: Option<std::cmp::Ordering>| match op {
        Op::Equal => Some(order.is_some_and(std::cmp::Ordering::is_eq)),
        Op::NotEqual => Some(order.is_none_or(std::cmp::Ordering::is_ne)),
        Op::Less => Some(order.is_some_and(std::cmp::Ordering::is_lt)),
        Op::LessEqual => Some(order.is_some_and(std::cmp::Ordering::is_le)),
        Op::Greater => Some(order.is_some_and(std::cmp::Ordering::is_gt)),
        Op::GreaterEqual => Some(order.is_some_and(std::cmp::Ordering::is_ge)),
        _ => None,
    };
    let order = match (a, b) {
        (Float(a), Float(b)) => a.partial_cmp(b),
        (Whole(a), Whole(b)) => Some(a.cmp(b)),
        (Signed(a), Signed(b)) => Some(a.cmp(b)),
        (Truth(a), Truth(b)) => Some(a.cmp(b)),
        _ => None,
    };
    if let Some(truth) = compared(order) {
        return Truth(truth);
    }
    match (op, a, b) {
        (Op::Add, Float(a), Float(b)) => Float(a + b),
        (Op::Subtract, Float(a), Float(b)) => Float(a - b),
        (Op::Multiply, Float(a), Float(b)) => Float(a * b),
        (Op::Divide, Float(a), Float(b)) => Float(a / b),
        (Op::Add, Whole(a), Whole(b)) => Whole(a.wrapping_add(*b)),
        (Op::Subtract, Whole(a), Whole(b)) => Whole(a.wrapping_sub(*b)),
        (Op::Multiply, Whole(a), Whole(b)) => Whole(a.wrapping_mul(*b)),
        (Op::Divide, Whole(a), Whole(b)) => Whole(a / b),
        (Op::Modulo, Whole(a), Whole(b)) => Whole(a % b),
        (Op::And, Whole(a), Whole(b)) => Whole(a & b),
        (Op::InclusiveOr, Whole(a), Whole(b)) => Whole(a | b),
        (Op::ShiftLeft, Whole(a), Whole(b)) => Whole(a << b),
        (Op::ShiftRight, Whole(a), Whole(b)) => Whole(a >> b),
        (Op::Add, Signed(a), Signed(b)) => Signed(a + b),
        (Op::Subtract, Signed(a), Signed(b)) => Signed(a - b),
        (Op::Multiply, Signed(a), Signed(b)) => Signed(a * b),
        (Op::Divide, Signed(a), Signed(b)) => Signed(a / b),
        (Op::And, Signed(a), Signed(b)) => Signed(a & b),
        (Op::And, Truth(a), Truth(b)) => Truth(*a && *b),
        (Op::InclusiveOr, Truth(a), Truth(b)) => Truth(*a || *b),
        other => panic!("{other:?} is in no shader here"),
    }
}
