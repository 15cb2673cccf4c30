//! How many operations a kernel of `shaders/` does: its text, as naga reads it, is run number by number on arrays of zeros,
//! which are the undeformed grid. Additions, multiplications, divisions and roots of floats count, a vector's and a matrix's
//! by their numbers; signs, comparisons and whole numbers are free. What a compiler finds to be the same twice counts twice.

use super::values::Value;
use Value::{Many, Place, Stored, Whole};
use naga::front::wgsl;
use naga::{
    AddressSpace, Binding, Block, BuiltIn, Expression, Function, Handle, Module, RelationalFunction, Statement, Type,
    TypeInner,
};
use std::collections::HashMap;

/// Invocations of a workgroup.
const GROUP: u32 = 64;

/// A module, and what its uniforms hold.
pub struct Kernels {
    module: Module,
    uniforms: HashMap<&'static str, Vec<f64>>,
}

impl Kernels {
    pub fn new(text: &str) -> Self {
        let module = wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
        Self { module, uniforms: HashMap::new() }
    }

    /// The members of a uniform, in their order.
    pub fn set(&mut self, name: &'static str, members: &[f64]) {
        self.uniforms.insert(name, members.to_vec());
    }

    /// Of one invocation of an entry point.
    pub fn operations(&self, entry: &str, order: u8, invocation: usize) -> u64 {
        let entry = self.module.entry_points.iter().find(|point| point.name == entry).expect("a kernel");
        let number = invocation as u32;
        let arguments = entry.function.arguments.iter().map(|argument| match argument.binding {
            Some(Binding::BuiltIn(BuiltIn::LocalInvocationIndex)) => Whole(number % GROUP),
            Some(Binding::BuiltIn(BuiltIn::WorkGroupId)) => Many([number / GROUP, 0, 0].map(Whole).into()),
            _ => Many([number, 0, 0].map(Whole).into()),
        });
        let mut run = Run { kernels: self, order: u32::from(order), memory: Vec::new(), operations: 0 };
        run.call(&entry.function, arguments.collect());
        run.operations
    }
}

struct Run<'a> {
    kernels: &'a Kernels,
    order: u32,
    /// Local variables of the functions that are being called.
    memory: Vec<Value>,
    operations: u64,
}

/// A function that is being called.
struct Call<'a> {
    function: &'a Function,
    arguments: Vec<Value>,
    /// Where its variables begin.
    first: usize,
    values: HashMap<Handle<Expression>, Value>,
}

/// What comes after a statement.
enum Flow {
    Next,
    Break,
    Continue,
    Return(Option<Value>),
}

impl<'a> Run<'a> {
    fn inner(&self, ty: Handle<Type>) -> &'a TypeInner {
        &self.kernels.module.types[ty].inner
    }

    fn zero(&self, ty: Handle<Type>) -> Value {
        let many = |value: Value, count: usize| Many(vec![value; count]);
        match self.inner(ty) {
            TypeInner::Scalar(scalar) => Value::zero(scalar.kind),
            TypeInner::Vector { size, scalar } => many(Value::zero(scalar.kind), *size as usize),
            TypeInner::Matrix { columns, rows, scalar } => {
                many(many(Value::zero(scalar.kind), *rows as usize), *columns as usize)
            }
            TypeInner::Array { base, size: naga::ArraySize::Constant(size), .. } => {
                many(self.zero(*base), size.get() as usize)
            }
            TypeInner::Struct { members, .. } => Many(members.iter().map(|member| self.zero(member.ty)).collect()),
            other => panic!("there is no zero of {other:?}"),
        }
    }

    fn call(&mut self, function: &'a Function, arguments: Vec<Value>) -> Option<Value> {
        let first = self.memory.len();
        let mut call = Call { function, arguments, first, values: HashMap::new() };
        for (_, variable) in function.local_variables.iter() {
            let value = match variable.init {
                Some(init) => self.value(&mut call, init),
                None => self.zero(variable.ty),
            };
            self.memory.push(value);
        }
        let flow = self.block(&mut call, &function.body);
        self.memory.truncate(first);
        if let Flow::Return(value) = flow { value } else { None }
    }

    fn block(&mut self, call: &mut Call<'a>, block: &'a Block) -> Flow {
        for statement in block {
            let flow = self.statement(call, statement);
            if !matches!(flow, Flow::Next) {
                return flow;
            }
        }
        Flow::Next
    }

    fn statement(&mut self, call: &mut Call<'a>, statement: &'a Statement) -> Flow {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    let value = self.evaluate(call, handle);
                    call.values.insert(handle, value);
                }
            }
            Statement::Block(block) => return self.block(call, block),
            Statement::If { condition, accept, reject } => {
                let is_so = self.value(call, *condition).is();
                return self.block(call, if is_so { accept } else { reject });
            }
            Statement::Loop { body, continuing, break_if } => loop {
                match self.block(call, body) {
                    Flow::Next | Flow::Continue => {}
                    Flow::Break => break,
                    flow @ Flow::Return(_) => return flow,
                }
                self.block(call, continuing);
                if break_if.is_some_and(|end| self.value(call, end).is()) {
                    break;
                }
            },
            Statement::Break => return Flow::Break,
            Statement::Continue => return Flow::Continue,
            Statement::Return { value } => return Flow::Return(value.map(|value| self.value(call, value))),
            Statement::ControlBarrier(_) => {}
            Statement::Store { pointer, value } => {
                let value = self.value(call, *value);
                if let Place(variable, path) = self.value(call, *pointer) {
                    let whole = &mut self.memory[variable];
                    *path.iter().fold(whole, |whole, &index| &mut whole.parts_mut()[index]) = value;
                }
            }
            Statement::Call { function, arguments, result } => {
                let arguments = arguments.iter().map(|&argument| self.value(call, argument)).collect();
                let answer = self.call(&self.kernels.module.functions[*function], arguments);
                if let (Some(result), Some(answer)) = (result, answer) {
                    call.values.insert(*result, answer);
                }
            }
            other => panic!("{other:?} is in no shader here"),
        }
        Flow::Next
    }

    /// What was computed, or what needs no computing.
    fn value(&mut self, call: &mut Call<'a>, handle: Handle<Expression>) -> Value {
        match call.values.get(&handle) {
            Some(value) => value.clone(),
            None => self.evaluate(call, handle),
        }
    }

    fn evaluate(&mut self, call: &mut Call<'a>, handle: Handle<Expression>) -> Value {
        match &call.function.expressions[handle] {
            Expression::Compose { components, ty } => {
                let parts: Vec<Value> = components.iter().map(|&part| self.value(call, part)).collect();
                match self.inner(*ty) {
                    // Of numbers and shorter vectors.
                    TypeInner::Vector { .. } => Many(parts.iter().flat_map(Value::parts).cloned().collect()),
                    _ => Many(parts),
                }
            }
            Expression::Access { base, index } => {
                let index = match self.value(call, *index) {
                    Whole(index) => index as usize,
                    Value::Signed(index) => index as usize,
                    other => panic!("{other:?} is no index"),
                };
                self.part(call, *base, index)
            }
            Expression::AccessIndex { base, index } => self.part(call, *base, *index as usize),
            Expression::Splat { size, value } => Many(vec![self.value(call, *value); *size as usize]),
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(call, *vector);
                Many(pattern[..*size as usize].iter().map(|&part| vector.parts()[part as usize].clone()).collect())
            }
            Expression::FunctionArgument(number) => call.arguments[*number as usize].clone(),
            Expression::LocalVariable(variable) => Place(call.first + variable.index(), Vec::new()),
            Expression::GlobalVariable(variable) => {
                let variable = &self.kernels.module.global_variables[*variable];
                match variable.space {
                    AddressSpace::Uniform => self.uniform(variable.name.as_deref().unwrap_or_default(), variable.ty),
                    _ => Stored(variable.ty),
                }
            }
            Expression::Load { pointer } => match self.value(call, *pointer) {
                Place(variable, path) => {
                    path.iter().fold(&self.memory[variable], |whole, &index| &whole.parts()[index]).clone()
                }
                Stored(ty) => self.zero(ty),
                value => value,
            },
            Expression::Unary { op, expr } => self.value(call, *expr).unary(*op),
            Expression::Binary { op, left, right } => {
                let right = self.value(call, *right);
                let (value, operations) = self.value(call, *left).binary(*op, &right);
                self.operations += operations;
                value
            }
            Expression::Select { condition, accept, reject } => {
                let [accept, reject] = [accept, reject].map(|&part| self.value(call, part));
                self.value(call, *condition).selected(&accept, &reject)
            }
            Expression::Relational { fun, argument } => {
                let truths = self.value(call, *argument);
                let is_all = *fun == RelationalFunction::All;
                let mut truths = truths.parts().iter().map(Value::is);
                Value::Truth(if is_all { truths.all(|x| x) } else { truths.any(|x| x) })
            }
            Expression::Math { fun, arg, arg1, arg2, .. } => {
                let [second, third] = [arg1, arg2].map(|arg| arg.map(|arg| self.value(call, arg)));
                let (value, operations) = self.value(call, *arg).math(*fun, second.as_ref(), third.as_ref());
                self.operations += operations;
                value
            }
            Expression::As { expr, kind, .. } => self.value(call, *expr).converted(*kind),
            Expression::ArrayLength(_) => Whole(1),
            constant => self.constant(constant),
        }
    }

    fn constant(&self, expression: &Expression) -> Value {
        let module = &self.kernels.module;
        let global = |handle: Handle<Expression>| self.constant(&module.global_expressions[handle]);
        match expression {
            Expression::Literal(literal) => Value::of(*literal),
            Expression::Constant(constant) => global(module.constants[*constant].init),
            Expression::Override(_) => Whole(self.order),
            Expression::ZeroValue(ty) => self.zero(*ty),
            Expression::Compose { components, .. } => Many(components.iter().map(|&part| global(part)).collect()),
            other => panic!("{other:?} is in no shader here"),
        }
    }

    fn uniform(&self, name: &str, ty: Handle<Type>) -> Value {
        let (numbers, zeros) = (&self.kernels.uniforms[name], self.zero(ty));
        assert_eq!(numbers.len(), zeros.parts().len(), "{name}");
        let member = |(&number, zero): (&f64, &Value)| match zero {
            Value::Float(_) => Value::Float(number),
            _ => Whole(number as u32),
        };
        Many(numbers.iter().zip(zeros.parts()).map(member).collect())
    }

    /// Of a value, or of what a pointer points to.
    fn part(&mut self, call: &mut Call<'a>, base: Handle<Expression>, index: usize) -> Value {
        match self.value(call, base) {
            Place(variable, mut path) => {
                path.push(index);
                Place(variable, path)
            }
            Stored(ty) => match self.inner(ty) {
                TypeInner::Array { base, .. } => Stored(*base),
                TypeInner::Struct { members, .. } => Stored(members[index].ty),
                TypeInner::Vector { scalar, .. } => Value::zero(scalar.kind),
                other => panic!("{other:?} has no parts"),
            },
            value => value.parts()[index].clone(),
        }
    }
}
