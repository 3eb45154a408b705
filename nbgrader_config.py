"""nbgrader: solutions/ is the source, exercises/ the release, everything else lives in build/."""

import os
import sys
from pathlib import Path

# nbgrader makes no folder for its database, and calls a program that stands beside this Python.
Path(__file__).with_name("build").mkdir(exist_ok=True)
os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])

c = get_config()  # noqa: F821  (nbgrader puts it there)

c.CourseDirectory.course_id = "amrmetrics"
c.CourseDirectory.source_directory = "solutions"
c.CourseDirectory.release_directory = "exercises"
c.CourseDirectory.submitted_directory = "build/submitted"
c.CourseDirectory.autograded_directory = "build/autograded"
c.CourseDirectory.feedback_directory = "build/feedback"
c.CourseDirectory.db_url = "sqlite:///build/gradebook.db"

# What stands where an answer belongs: it runs, so that an untouched exercise fails in its checks
# only, each with "there is no answer yet".
c.ClearSolutions.code_stub = {"python": "...  # your answer here"}
c.ClearSolutions.text_stub = "*Your answer here.*"
c.ClearSolutions.begin_solution_delimeter = "### BEGIN SOLUTION"
c.ClearSolutions.end_solution_delimeter = "### END SOLUTION"
