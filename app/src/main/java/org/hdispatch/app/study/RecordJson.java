package org.hdispatch.app.study;

import com.fasterxml.jackson.jr.ob.JSON;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Public records as JSON objects, component by component: numbers, strings, names of enum
 * constants, records, lists of these, and null for what is empty.
 */
final class RecordJson {
  private static final JSON TEXT =
      JSON.std.with(JSON.Feature.PRETTY_PRINT_OUTPUT, JSON.Feature.WRITE_NULL_PROPERTIES);

  private RecordJson() {}

  /** A record, or a list of records, as text. */
  static String write(Object value) throws IOException {
    return TEXT.asString(toJson(value)) + "\n";
  }

  /**
   * The record of a text.
   *
   * @throws IOException if the text is no JSON, or not of this record
   */
  static <R extends Record> R read(Class<R> type, String text) throws IOException {
    try {
      return type.cast(fromJson(type, JSON.std.mapFrom(text)));
    } catch (ReflectiveOperationException | RuntimeException | IOException e) {
      throw new IOException("JSON must be of a " + type.getSimpleName() + ": cause=" + e, e);
    }
  }

  private static Object toJson(Object value) {
    if (value instanceof Record) {
      Map<String, Object> members = new LinkedHashMap<>();
      for (RecordComponent each : value.getClass().getRecordComponents()) {
        members.put(each.getName(), toJson(component(each, value)));
      }
      return members;
    }
    if (value instanceof List<?> list) {
      return list.stream().map(RecordJson::toJson).toList();
    }
    if (value instanceof Optional<?> optional) {
      return toJson(optional.orElse(null));
    }
    return value instanceof Enum<?> constant ? constant.name() : value;
  }

  private static Object component(RecordComponent component, Object of) {
    try {
      return component.getAccessor().invoke(of);
    } catch (ReflectiveOperationException e) {
      throw new IllegalArgumentException("record must be readable: record=" + of, e);
    }
  }

  private static Object fromJson(Type type, Object json) throws ReflectiveOperationException {
    if (type instanceof ParameterizedType generic) {
      Type of = generic.getActualTypeArguments()[0];
      if (generic.getRawType() == Optional.class) {
        return json == null ? Optional.empty() : Optional.of(fromJson(of, json));
      }
      List<Object> list = new ArrayList<>();
      for (Object each : (List<?>) json) {
        list.add(fromJson(of, each));
      }
      return List.copyOf(list);
    }
    Class<?> plain = (Class<?>) type;
    if (plain.isRecord()) {
      return record(plain, (Map<?, ?>) json);
    }
    if (plain.isEnum()) {
      for (Object constant : plain.getEnumConstants()) {
        if (((Enum<?>) constant).name().equals(json)) {
          return constant;
        }
      }
      throw new IllegalArgumentException(plain.getSimpleName() + " must be known: name=" + json);
    }
    if (plain == String.class) {
      return (String) json;
    }
    Number number = (Number) json;
    if (plain == int.class) {
      return number.intValue();
    }
    return plain == long.class || plain == Long.class
        ? (Object) number.longValue()
        : (Object) number.doubleValue();
  }

  private static Object record(Class<?> type, Map<?, ?> json) throws ReflectiveOperationException {
    RecordComponent[] components = type.getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    Object[] values = new Object[components.length];
    for (int n = 0; n < components.length; n++) {
      String name = components[n].getName();
      if (!json.containsKey(name)) {
        throw new IllegalArgumentException("member must be there: name=" + name);
      }
      types[n] = components[n].getType();
      values[n] = fromJson(components[n].getGenericType(), json.get(name));
    }
    Constructor<?> constructor = type.getDeclaredConstructor(types);
    return constructor.newInstance(values);
  }
}
