//! What the JSON Schemas say, in the terms of a program.

use bifdiag_schema as schema;
use schemars::generate::SchemaSettings;
use serde_json::Value;

/// Every type of every document, by its name.
pub struct Model {
    pub types: Vec<Type>,
}

/// A named type.
pub struct Type {
    /// Without the `Document` with which it ends in Rust.
    pub name: String,
    pub about: String,
    pub form: Form,
}

pub enum Form {
    /// An object.
    Record(Vec<Field>),
    /// One of several constants, each with its meaning.
    Words(Vec<(Value, String)>),
    /// Something else, such as a text of a certain form.
    Other(Kind),
}

pub struct Field {
    pub name: String,
    pub about: String,
    pub kind: Kind,
    /// It may be absent.
    pub optional: bool,
}

/// What a field holds.
#[derive(Clone)]
pub enum Kind {
    Text,
    Number,
    Integer,
    Boolean,
    Constant(Value),
    Of(String),
    List(Box<Kind>),
    /// A list of so many.
    Several(Box<Kind>, u64),
    /// A list of these.
    Tuple(Vec<Kind>),
    /// An object with any names.
    Map(Box<Kind>),
    OrNull(Box<Kind>),
    Either(Vec<Kind>),
}

impl Model {
    pub fn of_documents() -> Self {
        let mut generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
        macro_rules! documents {
            ($($name:ident)*) => { $(generator.subschema_for::<schema::$name>();)* };
        }
        documents! {
            Head GivenBody AtlasDocument ClassificationDocument GridDocument CriticalDocument SectionsDocument MotionDocument
            ProvedMotionDocument ChaosPointDocument ChaosMapDocument PartAnswerDocument SteadyAxesDocument StateDocument CriticalSpinDocument SteadySpinsDocument SpinDownDocument
            PeriodicDocument PeriodicFamiliesDocument PeriodicListDocument ManifoldsDocument
            BodiesDocument ExplanationDocument BatchErrorDocument
            RowDocument ScanSummaryDocument BorderDocument EventTracksDocument ComparisonDocument PointProofDocument FindDocument ClassesDocument StandingDocument
        }
        let definitions = generator.take_definitions(true);
        let types = definitions.iter().map(|(name, schema)| Type {
            name: short(name).to_owned(),
            about: about(schema),
            form: form(schema),
        });
        Self { types: types.collect() }
    }

    pub fn find(&self, name: &str) -> Option<&Type> {
        self.types.iter().find(|of| of.name == name)
    }

    /// The constants of a kind that is a named list of them.
    pub fn words(&self, kind: &Kind) -> Option<&[(Value, String)]> {
        let name = match kind {
            Kind::Of(name) => name,
            Kind::OrNull(inner) | Kind::List(inner) | Kind::Several(inner, _) => return self.words(inner),
            _ => return None,
        };
        match &self.find(name)?.form {
            Form::Words(words) => Some(words),
            _ => None,
        }
    }

    /// The types that some need, these included, in the order of their names.
    pub fn needed(&self, roots: &[&str]) -> Vec<&Type> {
        let mut names: Vec<String> = roots.iter().map(|name| (*name).to_owned()).collect();
        let mut next = 0;
        while let Some(name) = names.get(next).cloned() {
            next += 1;
            let Some(of) = self.find(&name) else { continue };
            let mut add = |kind: &Kind| {
                kind.for_each_name(&mut |name| {
                    if !names.iter().any(|known| known == name) {
                        names.push(name.to_owned());
                    }
                });
            };
            match &of.form {
                Form::Record(fields) => fields.iter().for_each(|field| add(&field.kind)),
                Form::Other(kind) => add(kind),
                Form::Words(_) => {}
            }
        }
        self.types.iter().filter(|of| names.contains(&of.name)).collect()
    }
}

impl Kind {
    fn for_each_name(&self, act: &mut impl FnMut(&str)) {
        match self {
            Self::Of(name) => act(name),
            Self::List(inner) | Self::Several(inner, _) | Self::Map(inner) | Self::OrNull(inner) => {
                inner.for_each_name(act);
            }
            Self::Either(kinds) | Self::Tuple(kinds) => kinds.iter().for_each(|kind| kind.for_each_name(act)),
            Self::Text | Self::Number | Self::Integer | Self::Boolean | Self::Constant(_) => {}
        }
    }
}

fn short(name: &str) -> &str {
    name.strip_suffix("Document").unwrap_or(name)
}

fn text<'a>(schema: &'a Value, key: &str) -> Option<&'a str> {
    schema.get(key)?.as_str()
}

/// The description on one line.
fn about(schema: &Value) -> String {
    text(schema, "description").unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
}

fn form(schema: &Value) -> Form {
    if let Some(fields) = schema.get("properties").and_then(Value::as_object) {
        let required = schema.get("required").and_then(Value::as_array);
        let is_required = |name: &str| required.is_some_and(|names| names.iter().any(|known| known == name));
        let field = |(name, schema): (&String, &Value)| {
            let optional = !is_required(name);
            let kind = match kind(schema) {
                // What may be absent is never null.
                Kind::OrNull(inner) if optional => *inner,
                kind => kind,
            };
            Field { name: name.clone(), about: about(schema), kind, optional }
        };
        return Form::Record(fields.iter().map(field).collect());
    }
    let constants = |list: &Vec<Value>| -> Option<Vec<(Value, String)>> {
        list.iter().map(|one| Some((one.get("const")?.clone(), about(one)))).collect()
    };
    match schema.get("oneOf").and_then(Value::as_array).and_then(constants) {
        Some(words) => Form::Words(words),
        None => Form::Other(kind(schema)),
    }
}

fn kind(schema: &Value) -> Kind {
    if let Some(path) = text(schema, "$ref") {
        return Kind::Of(short(path.rsplit('/').next().unwrap_or_default()).to_owned());
    }
    if let Some(value) = schema.get("const") {
        return Kind::Constant(value.clone());
    }
    if let Some(values) = schema.get("enum").and_then(Value::as_array) {
        return Kind::Either(values.iter().cloned().map(Kind::Constant).collect());
    }
    if let Some(list) = ["anyOf", "oneOf"].iter().find_map(|key| schema.get(*key)?.as_array()) {
        let is_null = |one: &Value| text(one, "type") == Some("null");
        let mut kinds: Vec<Kind> = list.iter().filter(|one| !is_null(one)).map(kind).collect();
        let found = if kinds.len() == 1 { kinds.remove(0) } else { Kind::Either(kinds) };
        return if list.iter().any(is_null) { Kind::OrNull(Box::new(found)) } else { found };
    }
    if let Some(types) = schema.get("type").and_then(Value::as_array) {
        let mut bare = schema.clone();
        bare["type"] = types.iter().find(|name| *name != "null").cloned().unwrap_or_default();
        return Kind::OrNull(Box::new(kind(&bare)));
    }
    let inner = |key: &str| schema.get(key).map_or(Kind::Text, kind);
    match text(schema, "type") {
        Some("number") => Kind::Number,
        Some("integer") => Kind::Integer,
        Some("boolean") => Kind::Boolean,
        Some("array") if schema.get("prefixItems").is_some() => {
            Kind::Tuple(schema["prefixItems"].as_array().into_iter().flatten().map(kind).collect())
        }
        Some("array") => match schema.get("maxItems").and_then(Value::as_u64) {
            Some(count) => Kind::Several(Box::new(inner("items")), count),
            None => Kind::List(Box::new(inner("items"))),
        },
        Some("object") if schema.get("properties").is_some() => Kind::Of("object".to_owned()),
        Some("object") => {
            let numbered = schema.get("patternProperties").and_then(Value::as_object);
            let values = numbered.and_then(|patterns| patterns.values().next());
            Kind::Map(Box::new(values.map_or_else(|| inner("additionalProperties"), kind)))
        }
        _ => Kind::Text,
    }
}
