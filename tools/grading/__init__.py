"""Grade submissions in processes that the students' code cannot leave.

Who does what, each in a process of its own::

    tools/grade.py    finds submissions, hands them out, writes tables and pages
      worker          has the solutions and the checks, and has proved what the solutions prove;
                      forks a checker for each submission, so many at a time
        checker       reads one notebook, runs the official checks on what the student's process
                      hands over: plain data, and functions that are called from afar
        zygote        knows the library and no solution; forks students' processes
          guard       makes the isolation, waits for the student's process and ends it
            student   runs the cells: no network, no files but its own, limits of everything

The student's code never runs where a check runs. What crosses is plain (see `wire`), so that all
a student's process can do is to send another answer.
"""
