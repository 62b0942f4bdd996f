#!/bin/sh
# A survey by Spark on this machine: two executors of one core each, one of them killed with its task;
# then the same survey in one process, and the two tables compared. Takes one to three minutes.
# IMAGE BLOCK AXES FIRST-LAST [FOLDER]: an HDF5 image with voxel_size_m, and which of its blocks.
set -eu
if [ $# -lt 4 ]; then
  echo "usage: $0 IMAGE.h5 BLOCK AXES FIRST-LAST [FOLDER]" >&2
  exit 2
fi
here=$(cd "$(dirname "$0")" && pwd -P)
image=$1 block=$2 axes=$3 blocks=$4 to=${5:-$(mktemp -d)}
java=${JAVA_HOME:+$JAVA_HOME/bin/}java

# Workers start executors with what lies in $SPARK_HOME/jars; Maven knows where Spark's jars are.
export SPARK_HOME="$to/spark" SPARK_SCALA_VERSION=2.13
mkdir -p "$SPARK_HOME/jars"
mvn -q -o -f "$here/pom.xml" dependency:build-classpath -Dmdep.includeScope=compile -Dmdep.outputFile="$to/classpath"
tr ':' '\n' < "$to/classpath" | while read -r jar; do ln -sf "$jar" "$SPARK_HOME/jars/"; done
ln -sf "$here"/target/spark-1.jar "$here"/target/lib/*.jar "$SPARK_HOME/jars/"

opens=
for package in java.lang java.lang.invoke java.lang.reflect java.io java.net java.nio java.util \
  java.util.concurrent java.util.concurrent.atomic sun.nio.ch sun.nio.cs sun.security.action sun.util.calendar; do
  opens="$opens --add-opens=java.base/$package=ALL-UNNAMED"
done
# shellcheck disable=SC2086
"$java" $opens -Xmx512m -cp "$SPARK_HOME/jars/*" -Dspark.master='local-cluster[2,1,1024]' \
  -Dspark.executor.cores=1 -Dspark.executor.memory=1g -Dspark.ui.enabled=false \
  -Dspark.executor.extraJavaOptions=-Dhdispatch.demo="$to" \
  org.hdispatch.example.spark.SparkSurvey "$image" "$block" "$axes" "$to/by-spark" "$blocks" \
  > "$to/spark.log" 2>&1 &
driver=$!

rows() { cat "$to/by-spark/survey.csv" 2>/dev/null | wc -l; }
while [ "$(rows)" -lt 4 ]; do
  kill -0 $driver || { tail -20 "$to/spark.log"; exit 1; }
  sleep 0.2
done
victim=$(pgrep -f "hdispatch.demo=$to .*CoarseGrainedExecutorBackend" | head -1)
echo "killing executor $victim after $(($(rows) - 1)) rows"
kill -9 "$victim"
wait $driver
echo "tasks lost: $(grep -c 'Lost task' "$to/spark.log" || true)"

"$here/../../hdispatch" survey "$image" --block "$block" --axis "$axes" --blocks "$blocks" --threads 1 \
  --quiet --output "$to/by-one" > /dev/null
cmp "$to/by-spark/survey.csv" "$to/by-one/survey.csv"
cmp "$to/by-spark/survey.properties" "$to/by-one/survey.properties"
echo "the same $(($(rows) - 1)) rows: $to/by-spark/survey.csv"
