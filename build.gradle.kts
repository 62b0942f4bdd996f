// For users of Gradle 8.9 or newer; see settings.gradle. Formatting, javadoc and the runnable jar
// are left to Maven.

val catalog = extensions.getByType<VersionCatalogsExtension>().named("libs")

/** A library that pom.xml manages, with its version from there. */
fun lib(artifactId: String) = catalog.findLibrary(artifactId).get()

/** What Maven's Surefire adds by itself; its version comes with junit-jupiter. */
val launcher = "org.junit.platform:junit-platform-launcher"

/** What the modules with the Vector API need, compiled and tested. */
val incubator = listOf("--add-modules", "jdk.incubator.vector")

subprojects {
    apply(plugin = "java-library")
    val usesIncubator = name in listOf("lbm-vector", "sph-vector")

    configure<BasePluginExtension> {
        archivesName.set(if (name == "hdispatch-core") name else "hdispatch-$name")
    }
    configure<JavaPluginExtension> {
        withSourcesJar()
    }
    tasks.withType<AbstractArchiveTask>().configureEach {
        isPreserveFileTimestamps = false
        isReproducibleFileOrder = true
    }
    tasks.withType<JavaCompile>().configureEach {
        val release = catalog.findVersion("java-release").get().requiredVersion
        if (usesIncubator) {
            sourceCompatibility = release
            targetCompatibility = release
        } else {
            options.release.set(release.toInt())
        }
        options.encoding = "UTF-8"
        options.compilerArgs.addAll(
            listOf(
                "-parameters",
                "-Xlint:all,-processing,-requires-automatic",
                "-Xdoclint:all,-missing",
                "-Werror",
            ),
        )
        if (usesIncubator) {
            // The releases that javac knows leave incubator modules out, and it warns of them.
            options.compilerArgs.remove("-Werror")
            options.compilerArgs.addAll(incubator)
        }
    }
    tasks.withType<Test>().configureEach {
        val validation = providers.gradleProperty("validation").isPresent // gradle -Pvalidation test
        if (usesIncubator) jvmArgs(incubator)
        useJUnitPlatform {
            if (validation) includeTags("validation") else excludeTags("validation")
        }
        include("**/*Test.class")
        // Folder with the large rock images; tests that need it are skipped without it.
        systemProperty("hdispatch.data", providers.systemProperty("hdispatch.data").getOrElse(""))
    }
}

// Maven's scopes: compile is "api" where a signature of the module shows it, else "implementation";
// runtime is "runtimeOnly"; test is "testImplementation"; provided is "annotationProcessor".

project(":hdispatch-core") {
    dependencies {
        "implementation"(lib("eclipse-collections-api"))
        "implementation"(lib("eclipse-collections"))
        "testImplementation"(lib("junit-jupiter"))
        "testImplementation"(lib("jqwik"))
        "testRuntimeOnly"(launcher)
    }
}

project(":sph") {
    dependencies {
        "api"(project(":hdispatch-core"))
        "testImplementation"(lib("junit-jupiter"))
        "testRuntimeOnly"(launcher)
    }
}

project(":lbm") {
    dependencies {
        "api"(project(":hdispatch-core"))
        "testImplementation"(lib("junit-jupiter"))
        "testImplementation"(lib("jqwik"))
        "testRuntimeOnly"(launcher)
    }
}

project(":lbm-vector") {
    dependencies {
        "implementation"(project(":lbm"))
        "testImplementation"(lib("junit-jupiter"))
        "testRuntimeOnly"(launcher)
    }
}

project(":sph-vector") {
    dependencies {
        "implementation"(project(":sph"))
        "testImplementation"(lib("junit-jupiter"))
        "testRuntimeOnly"(launcher)
    }
}

project(":porous") {
    dependencies {
        "api"(project(":hdispatch-core"))
        "api"(project(":lbm"))
        "api"(project(":sph"))
        "implementation"(lib("jhdf"))
        "testImplementation"(lib("slf4j-nop"))
        "testImplementation"(lib("junit-jupiter"))
        "testImplementation"(lib("jqwik"))
        "testRuntimeOnly"(launcher)
    }
}

project(":app") {
    dependencies {
        "implementation"(project(":hdispatch-core"))
        "implementation"(project(":lbm"))
        "implementation"(project(":porous"))
        "implementation"(project(":sph"))
        "implementation"(lib("picocli"))
        "implementation"(lib("HdrHistogram"))
        "implementation"(lib("jackson-jr-objects"))
        "runtimeOnly"(project(":lbm-vector"))
        "runtimeOnly"(project(":sph-vector"))
        "runtimeOnly"(lib("slf4j-nop"))
        "testImplementation"(lib("junit-jupiter"))
        "testImplementation"(lib("archunit"))
        "testRuntimeOnly"(launcher)
    }
}

project(":jmh") {
    dependencies {
        "implementation"(project(":hdispatch-core"))
        "implementation"(project(":lbm"))
        "implementation"(project(":sph"))
        "implementation"(project(":porous"))
        "implementation"(project(":app"))
        "runtimeOnly"(project(":lbm-vector"))
        "runtimeOnly"(project(":sph-vector"))
        "implementation"(lib("jmh-core"))
        "annotationProcessor"(lib("jmh-generator-annprocess"))
        "testImplementation"(lib("junit-jupiter"))
        "testRuntimeOnly"(launcher)
    }
}
