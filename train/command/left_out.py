"""Help texts for optional values such as `float | None`, shown as a float that is unset by default."""

from dataclasses import replace
from typing import Any, Union, get_args

from tyro.constructors import (
    ConstructorRegistry,
    PrimitiveConstructorSpec,
    PrimitiveTypeInfo,
    UnsupportedTypeAnnotationError,
)

REGISTRY = ConstructorRegistry()
LEFT_OUT = "unset"  # the default that the help shows


@REGISTRY.primitive_rule
def parser_without_none(info: PrimitiveTypeInfo) -> PrimitiveConstructorSpec[Any] | None:
    """Return a parser for a type such as `float | None` that shows None as unset; None for other types."""
    kinds = tuple(kind for kind in get_args(info.type) if kind is not type(None))
    if len(kinds) == len(get_args(info.type)):
        return None
    other: Any = Union[kinds]  # noqa: UP007  # from a tuple
    inner = ConstructorRegistry.get_primitive_spec(PrimitiveTypeInfo.make(other, info.markers))
    if isinstance(inner, UnsupportedTypeAnnotationError):
        return None
    return replace(
        inner,
        is_instance=lambda value: value is None or inner.is_instance(value),
        str_from_instance=lambda value: [LEFT_OUT] if value is None else inner.str_from_instance(value),
    )
